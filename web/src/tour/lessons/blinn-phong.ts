// Lesson 5: Blinn's halfway vector (docs/theory/lighting-equation.md; Blinn, Models of light reflection, SIGGRAPH 1977).
import { angleBetween, highlightShare, highlightsOf, placeOnBall, shown, shownItalian, type Bench } from "../bench";
import type { SceneObject } from "../../engine/types";
import type { Changes } from "../../state/compare";
import type { Lesson } from "../lesson";

const kStrength = 0.75;
const kPhongExponent = 20;
const kAskedExponent = 50;

const kFloor: SceneObject = {
  name: "wet street",
  mesh: "primitive:plane",
  matrix: [8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 8, 0, 0, 0, 0, 1],
  material: { ambient: [0.02, 0.02, 0.03], diffuse: [0.03, 0.03, 0.04], specular: [0.8, 0.7, 0.5], shininess: 30 },
};

const asPhong = (shininess: number): Changes => [
  ["shading.lighting", "phong"],
  ["objects[0].material.shininess", shininess],
];
const asBlinn = (shininess: number): Changes => [
  ["shading.lighting", "blinn-phong"],
  ["objects[0].material.shininess", shininess],
];

/** How much longer than wide the highlight is, on the picture. */
async function stretch(bench: Bench): Promise<number> {
  const { floats, width } = await highlightsOf(bench).picture();
  let [weight, x1, y1, x2, y2] = [0, 0, 0, 0, 0];
  for (let i = 0; i < floats!.length; i += 4) {
    const w = floats![i]!;
    const x = (i >> 2) % width;
    const y = Math.floor((i >> 2) / width);
    weight += w;
    x1 += w * x;
    y1 += w * y;
    x2 += w * x * x;
    y2 += w * y * y;
  }
  return Math.sqrt((y2 / weight - (y1 / weight) ** 2) / (x2 / weight - (x1 / weight) ** 2));
}

/** The exponent with which Blinn-Phong's highlight is as large as Phong's. */
async function matchingExponent(bench: Bench, phongExponent: number): Promise<number> {
  const wanted = await highlightShare(bench.with(asPhong(phongExponent)), kStrength);
  let [low, high] = [phongExponent / 4, phongExponent * 16];
  for (let round = 0; round < 8; ++round) {
    const middle = Math.sqrt(low * high);
    if ((await highlightShare(bench.with(asBlinn(middle)), kStrength)) > wanted) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return Math.sqrt(low * high);
}

export const blinnPhong: Lesson = {
  id: "blinn-phong",
  title: { en: "Blinn-Phong", it: "Blinn-Phong" },
  about: { en: "Half of the way is enough", it: "Basta metà strada" },
  scene: {
    image: { background: [0.06, 0.07, 0.09] },
    camera: { view: "front" },
    shading: { lighting: "phong", interpolation: "phong" },
    ambient: [0.12, 0.12, 0.12],
    lights: [{ type: "directional", direction: [-0.3, -0.35, -0.89] }],
    objects: [
      {
        name: "ball",
        mesh: "primitive:sphere:96",
        material: { ambient: [0.05, 0.25, 0.12], diffuse: [0.05, 0.25, 0.12], specular: [kStrength, kStrength, kStrength], shininess: 20 },
      },
    ],
  },
  steps: [
    {
      title: { en: "The halfway vector", it: "Il vettore a metà strada" },
      text: {
        en: "Jim Blinn asked in 1977 what a rough surface is made of: of tiny mirrors that tilt by chance. One of them throws light from $\\mathbf L$ to $\\mathbf V$ exactly if it stands upright to the direction halfway between, $\\mathbf H$. So he measured how far $\\mathbf H$ is from $\\mathbf N$, and needed no $\\mathbf R$.",
        it: "Nel 1977 Jim Blinn si chiese di che cosa sia fatta una superficie ruvida: di minuscoli specchi inclinati a caso. Uno di essi manda la luce da $\\mathbf L$ a $\\mathbf V$ proprio se è perpendicolare alla direzione a metà strada, $\\mathbf H$. Così misurò quanto $\\mathbf H$ dista da $\\mathbf N$, e fece a meno di $\\mathbf R$.",
      },
      formula:
        "\\begin{aligned} \\mathbf H &= \\frac{\\mathbf L + \\mathbf V}{|\\mathbf L + \\mathbf V|} \\\\ \\operatorname{spec} &= \\max(\\mathbf N\\cdot\\mathbf H,\\, 0)^n \\end{aligned}",
      control: { tab: "shading", testid: "option-shading-lighting" },
      ask: {
        kind: "task",
        text: {
          en: "Choose the lighting model Blinn-Phong, and watch the size of the highlight.",
          it: "Scegli il modello Blinn-Phong e osserva la grandezza del riflesso.",
        },
        check: async (bench) => {
          if ((await bench.at([0, 0, 1]))?.fragment.lighting !== "blinn-phong") {
            return { ok: false };
          }
          const times = (await highlightShare(bench, kStrength)) / Math.max(1e-6, await highlightShare(bench.before(), kStrength));
          return {
            ok: true,
            say: {
              en: `The highlight is now ${shown(times, 1)} times as large.`,
              it: `Ora il riflesso è ${shownItalian(times, 1)} volte più grande.`,
            },
          };
        },
        hint: { en: "It stands next to Phong on the Shading tab.", it: "Sta accanto a Phong nella scheda Ombreggiatura." },
        because: {
          en: "The same exponent, another angle: the two models do not mean the same by $n$. Why, the next step says.",
          it: "Stesso esponente, altro angolo: con $n$ i due modelli non intendono la stessa cosa. Il prossimo passo dice perché.",
        },
        solution: { kind: "change", changes: [["shading.lighting", "blinn-phong"]] },
      },
    },
    {
      title: { en: "Tilt the surface", it: "Inclina la superficie" },
      text: {
        en: "$\\mathbf H$ does not know the surface: it stays while the surface tilts, so the angle between $\\mathbf N$ and $\\mathbf H$ grows by just the tilt. $\\mathbf R$ does not stay.",
        it: "$\\mathbf H$ non conosce la superficie: resta fermo mentre essa s'inclina, perciò l'angolo tra $\\mathbf N$ e $\\mathbf H$ cresce proprio dell'inclinazione. $\\mathbf R$ non resta fermo.",
      },
      formula: "\\mathbf R = 2(\\mathbf N\\cdot\\mathbf L)\\,\\mathbf N - \\mathbf L",
      scene: [["shading.lighting", "phong"]],
      control: { tab: "explain", testid: "tab-explain" },
      ask: {
        kind: "choice",
        text: {
          en: "The normal tilts by 10° further away from the light. By how much does $\\mathbf R$ turn?",
          it: "La normale s'inclina di altri 10° lontano dalla luce. Di quanto ruota $\\mathbf R$?",
        },
        options: [
          {
            text: { en: "By 5°", it: "Di 5°" },
            reply: {
              en: "Less than the normal itself? Think of a mirror in your hand and the spot that it throws onto the wall.",
              it: "Meno della normale? Pensa a uno specchio in mano e alla macchia che getta sul muro.",
            },
          },
          {
            text: { en: "By 10°", it: "Di 10°" },
            reply: {
              en: "That is how the normal turns. The light comes in 10° flatter and leaves 10° flatter, too.",
              it: "Così ruota la normale. La luce arriva 10° più radente, e anche riparte 10° più radente.",
            },
          },
          { text: { en: "By 20°", it: "Di 20°" }, reply: { en: "", it: "" } },
        ],
        answer: async (bench) => {
          const [near, far] = await Promise.all([
            placeOnBall(bench, 20).then((p) => bench.at(p)),
            placeOnBall(bench, 30).then((p) => bench.at(p)),
          ]);
          const turn =
            angleBetween(near!.light!.reflected, far!.light!.reflected) / angleBetween(near!.shading.normal, far!.shading.normal);
          return turn < 0.75 ? 0 : turn < 1.5 ? 1 : 2;
        },
        because: {
          en: "Twice as far. Phong's angle grows twice as fast as Blinn's, so Phong's highlight is the smaller one at the same $n$.",
          it: "Il doppio. L'angolo di Phong cresce due volte più in fretta di quello di Blinn, perciò a pari $n$ il riflesso di Phong è il più piccolo.",
        },
      },
    },
    {
      title: { en: "The wet street", it: "La strada bagnata" },
      text: {
        en: "Is Blinn's only Phong's with another $n$? On a ball nearly. Now you look along a wet street towards a lamp: Phong at the left, Blinn-Phong at the right, with the exponents that match on the ball.",
        it: "Blinn è solo Phong con un altro $n$? Su una palla quasi. Ora guardi lungo una strada bagnata verso un lampione: Phong a sinistra, Blinn-Phong a destra, con gli esponenti che sulla palla si equivalgono.",
      },
      scene: [
        ["camera", { eye: [0, 0.9, 7.5], target: [0, 0, 0], fov: 42 }],
        ["ambient", [0.1, 0.1, 0.1]],
        ["lights", [{ type: "point", name: "street lamp", position: [0, 1.6, -9] }]],
        ["objects", [kFloor]],
      ],
      comparison: { kind: "settings", left: asPhong(15), right: asBlinn(60) },
      isSideBySide: true,
      ask: {
        kind: "choice",
        text: {
          en: "Which one draws the long streak towards you, as wet streets do?",
          it: "Quale disegna la lunga striscia verso di te, come fanno le strade bagnate?",
        },
        options: [
          {
            text: { en: "Phong, left", it: "Phong, a sinistra" },
            reply: {
              en: "Its spot is nearly round: $\\mathbf R\\cdot\\mathbf V$ falls evenly to all sides. Look at the right.",
              it: "La sua macchia è quasi tonda: $\\mathbf R\\cdot\\mathbf V$ cala allo stesso modo da ogni parte. Guarda a destra.",
            },
          },
          {
            text: { en: "Both alike", it: "Tutti e due" },
            reply: { en: "Compare how wide and how long they are.", it: "Confronta quanto sono larghi e quanto lunghi." },
          },
          { text: { en: "Blinn-Phong, right", it: "Blinn-Phong, a destra" }, reply: { en: "", it: "" } },
        ],
        answer: async (bench) => {
          const [left, right] = await Promise.all([stretch(bench.with(asPhong(15))), stretch(bench.with(asBlinn(60)))]);
          return left > 1.2 * right ? 0 : right > 1.2 * left ? 2 : 1;
        },
        because: {
          en: "Seen flat, tilting a facet towards you moves $\\mathbf H$ little, tilting it sideways moves it a lot: the streak. Blinn's model came closer to measurements than Phong's, and OpenGL took it over.",
          it: "A vista radente, inclinare una faccetta verso di te sposta poco $\\mathbf H$, inclinarla di lato molto: ecco la striscia. Il modello di Blinn si avvicinò alle misure più di quello di Phong, e OpenGL lo adottò.",
        },
      },
    },
    {
      title: { en: "Making them match", it: "Farli combaciare" },
      text: {
        en: "Back to the ball. Left stands Phong with $n = 20$, right your scene: Blinn-Phong, with $n = 20$ as well. The wipe shows where they differ.",
        it: "Torniamo alla palla. A sinistra c'è Phong con $n = 20$, a destra la tua scena: Blinn-Phong, anch'essa con $n = 20$. Il cursore mostra dove differiscono.",
      },
      scene: [
        ["camera", { view: "front" }],
        ["ambient", [0.12, 0.12, 0.12]],
        ["lights", [{ type: "directional", direction: [-0.3, -0.35, -0.89] }]],
        [
          "objects",
          [
            {
              name: "ball",
              mesh: "primitive:sphere:96",
              material: {
                ambient: [0.05, 0.25, 0.12],
                diffuse: [0.05, 0.25, 0.12],
                specular: [kStrength, kStrength, kStrength],
                shininess: 20,
              },
            },
          ],
        ],
        ["shading.lighting", "blinn-phong"],
      ],
      comparison: { kind: "settings", left: asPhong(kPhongExponent), right: [] },
      control: { tab: "material", testid: "option-materials-x-shininess" },
      ask: {
        kind: "task",
        text: {
          en: "Change the exponent until the right highlight is as large as the left one (within 10 %).",
          it: "Cambia l'esponente finché il riflesso di destra è grande come quello di sinistra (entro il 10 %).",
        },
        check: async (bench) => {
          if ((await bench.at([0, 0, 1]))?.fragment.lighting !== "blinn-phong") {
            return { ok: false, say: { en: "The right one shall stay Blinn-Phong.", it: "Quello di destra deve restare Blinn-Phong." } };
          }
          const times = (await highlightShare(bench, kStrength)) / (await highlightShare(bench.with(asPhong(kPhongExponent)), kStrength));
          return {
            ok: Math.abs(times - 1) <= 0.1,
            say: {
              en: `The right one has ${shown(times)} times the area.`,
              it: `Quello di destra ha ${shownItalian(times)} volte l'area.`,
            },
          };
        },
        hint: {
          en: "It is too large, so $n$ must grow: by twice the angle, and so by more than twice.",
          it: "È troppo grande, quindi $n$ deve crescere: l'angolo conta il doppio, perciò serve più del doppio.",
        },
        because: {
          en: "About four times the exponent. Near the middle $\\cos^n\\alpha \\approx e^{-n\\alpha^2/2}$: twice the angle counts four times.",
          it: "Circa quattro volte l'esponente. Vicino al centro $\\cos^n\\alpha \\approx e^{-n\\alpha^2/2}$: il doppio dell'angolo conta quattro volte.",
        },
        solution: {
          kind: "change",
          changes: async (bench) => [["objects[0].material.shininess", Math.round(await matchingExponent(bench, kPhongExponent))]],
        },
      },
    },
    {
      title: { en: "Question: translate a material", it: "Domanda: traduci un materiale" },
      text: {
        en: "A material was made for a renderer with Phong's model, with $n = 50$. Yours has Blinn-Phong. The picture shows the original.",
        it: "Un materiale è stato fatto per un renderer con il modello di Phong, con $n = 50$. Il tuo usa Blinn-Phong. L'immagine mostra l'originale.",
      },
      scene: asPhong(kAskedExponent),
      ask: {
        kind: "number",
        text: {
          en: "Which exponent gives your highlight the same size on the ball?",
          it: "Quale esponente dà al tuo riflesso la stessa grandezza sulla palla?",
        },
        unit: "",
        answer: (bench) => matchingExponent(bench, kAskedExponent),
        tolerance: { relative: 0.15 },
        slips: [
          {
            fits: (given) => Math.abs(given - kAskedExponent / 4) < 1.5,
            say: {
              en: "That is the way back, from Blinn-Phong to Phong. Whose highlight is larger at the same $n$?",
              it: "Questa è la via del ritorno, da Blinn-Phong a Phong. A pari $n$, quale riflesso è più grande?",
            },
          },
          {
            fits: (given) => Math.abs(given - 2 * kAskedExponent) < 5,
            say: { en: "The angle doubles, but it counts by its square.", it: "L'angolo raddoppia, ma conta al quadrato." },
          },
          {
            fits: (given) => Math.abs(given - kAskedExponent) < 2,
            say: {
              en: "With the same exponent Blinn-Phong's was clearly larger.",
              it: "Con lo stesso esponente quello di Blinn-Phong era chiaramente più grande.",
            },
          },
        ],
        hint: { en: "In the step before, what did 20 become?", it: "Nel passo precedente, che cosa è diventato 20?" },
        because: {
          en: "Four times. Files seldom say which of the two their exponent means; now you know what goes wrong when it is the other.",
          it: "Quattro volte. Di rado i file dicono a quale dei due si riferisca l'esponente; ora sai che cosa succede quando è l'altro.",
        },
      },
      reveal: { comparison: { kind: "settings", left: [], right: asBlinn(4 * kAskedExponent) } },
    },
  ],
};
