// Lesson 6: flat, Gouraud and Phong shading (docs/theory/shading.md; Gouraud 1971, Phong 1975, Mach 1865).
import type { SceneObject, Vec3 } from "../../engine/types";
import { brightest, highlightPeak, shown, shownItalian, type Bench } from "../bench";
import type { Lesson, Mark } from "../lesson";

const kBall = (segments: number): SceneObject => ({
  name: "ball",
  mesh: `primitive:sphere:${segments}`,
  material: { ambient: [0.5, 0.1, 0.1], diffuse: [0.5, 0.1, 0.1], specular: [0.7, 0.7, 0.7], shininess: 60 },
});

/** Both on one face of the ball of 12 segments; A at the edge to the darker face below. */
const kEdge: Vec3 = [-0.131, 0.013, 0.962];
const kInside: Vec3 = [-0.335, 0.245, 0.845];
const kMarks: readonly Mark[] = [
  { letter: "A", at: kEdge },
  { letter: "B", at: kInside },
];

const kFloor: SceneObject = {
  name: "floor",
  mesh: "primitive:plane",
  matrix: [3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1],
  material: { ambient: [0.6, 0.55, 0.5], diffuse: [0.6, 0.55, 0.5] },
};

const interpolationOf = async (bench: Bench): Promise<string> => (await bench.readPixel(120, 90))?.explanation.interpolation ?? "";

export const interpolation: Lesson = {
  id: "interpolation",
  title: { en: "Flat, Gouraud, Phong", it: "Piatta, Gouraud, Phong" },
  about: {
    en: "Where the equation is asked, and what gets lost in between",
    it: "Dove si calcola l'equazione, e che cosa si perde in mezzo",
  },
  scene: {
    image: { background: [0.06, 0.07, 0.09] },
    camera: { view: "front" },
    shading: { lighting: "phong", interpolation: "flat" },
    ambient: [0.12, 0.12, 0.12],
    lights: [{ type: "directional", direction: [-0.5, -0.6, -1] }],
    objects: [kBall(12)],
  },
  steps: [
    {
      title: { en: "Once a face", it: "Una volta per faccia" },
      text: {
        en: "This ball is made of few flat faces, and **flat shading** asks the equation once for each of them, at its centre, with the face's own normal. The mesh shows as it is. Look along the edges between the faces: each brighter face seems to have an even brighter rim.",
        it: "Questa palla è fatta di poche facce piane, e l'**ombreggiatura piatta** calcola l'equazione una volta per ciascuna, al centro, con la normale della faccia. La mesh si vede com'è. Guarda lungo gli spigoli: ogni faccia più chiara sembra avere un bordo ancora più chiaro.",
      },
      marks: kMarks,
      control: { tab: "explain", testid: "tab-explain" },
      ask: {
        kind: "choice",
        text: {
          en: "A lies at the edge to a darker face, B inside of the same face. Which is brighter? Explain tells.",
          it: "A sta sul bordo verso una faccia più scura, B dentro la stessa faccia. Qual è più chiaro? Lo dice Spiega.",
        },
        options: [
          {
            text: { en: "A, at the edge", it: "A, sul bordo" },
            reply: {
              en: "So it seems. Choose A, then B, and compare the colours that Explain shows.",
              it: "Così sembra. Scegli A, poi B, e confronta i colori che mostra Spiega.",
            },
          },
          {
            text: { en: "B, inside", it: "B, all'interno" },
            reply: {
              en: "Choose A, then B, and compare the colours that Explain shows.",
              it: "Scegli A, poi B, e confronta i colori che mostra Spiega.",
            },
          },
          { text: { en: "They are equal", it: "Sono uguali" }, reply: { en: "", it: "" } },
        ],
        answer: async (bench) => {
          const [edge, inside] = (await Promise.all([bench.at(kEdge), bench.at(kInside)])).map((reading) => reading!.explanation.color[0]);
          return edge! > inside! ? 0 : inside! > edge! ? 1 : 2;
        },
        because: {
          en: "Equal to the last bit. Your eye sharpens edges by itself; these are the bands that Ernst Mach described in 1865, and they make facets look worse than they are.",
          it: "Uguali fino all'ultimo bit. È l'occhio che accentua i bordi: sono le bande descritte da Ernst Mach nel 1865, e fanno sembrare le sfaccettature peggiori di quel che sono.",
        },
      },
    },
    {
      title: { en: "Once a vertex", it: "Una volta per vertice" },
      text: {
        en: "In 1971 Henri Gouraud asked the equation at the vertices, with a normal averaged over the faces around, and spread the colours in between evenly over each triangle. Three evaluations a triangle, and the facets are gone: machines of that time could do it.",
        it: "Nel 1971 Henri Gouraud calcolò l'equazione nei vertici, con una normale mediata fra le facce intorno, e distribuì i colori su ogni triangolo. Tre calcoli per triangolo e le sfaccettature spariscono: le macchine di allora ce la facevano.",
      },
      formula: "I = \\lambda_0 I_0 + \\lambda_1 I_1 + \\lambda_2 I_2",
      control: { tab: "shading", testid: "option-shading-interpolation" },
      ask: {
        kind: "task",
        text: {
          en: "Choose Gouraud. Something else disappears with the facets: what?",
          it: "Scegli Gouraud. Con le sfaccettature sparisce anche un'altra cosa: quale?",
        },
        check: async (bench) => {
          if ((await interpolationOf(bench)) !== "gouraud") {
            return { ok: false };
          }
          const [was, is] = [await highlightPeak(bench.before()), await highlightPeak(bench)];
          return {
            ok: true,
            say: {
              en: `The strongest highlight was ${shown(was)}; now it is ${shown(is)}.`,
              it: `Il riflesso più forte era ${shownItalian(was)}; ora è ${shownItalian(is)}.`,
            },
          };
        },
        hint: { en: "Interpolation, on the Shading tab.", it: "Interpolazione, nella scheda Ombreggiatura." },
        because: {
          en: "The highlight is gone. It lies between vertices; none of them sees it, and no mixture of dark colours makes a bright one.",
          it: "È sparito il riflesso. Cade tra i vertici: nessuno di loro lo vede, e nessuna miscela di colori scuri ne fa uno chiaro.",
        },
        solution: { kind: "change", changes: [["shading.interpolation", "gouraud"]] },
      },
    },
    {
      title: { en: "More triangles", it: "Più triangoli" },
      text: {
        en: "The first remedy is brute force: more vertices, so that one of them comes to lie in the highlight. Not every refinement helps: with 32 segments a vertex happens to be near, with 48 it is not.",
        it: "Il primo rimedio è la forza bruta: più vertici, finché uno cade nel riflesso. Non ogni raffinamento aiuta: con 32 segmenti un vertice capita vicino, con 48 no.",
      },
      scene: [["shading.interpolation", "gouraud"]],
      control: { tab: "material", testid: "object-segments" },
      ask: {
        kind: "task",
        text: {
          en: "Refine the ball until Gouraud's highlight has at least 85 % of the strength that it should have.",
          it: "Raffina la palla finché il riflesso di Gouraud ha almeno l'85 % della forza che dovrebbe avere.",
        },
        check: async (bench) => {
          if ((await interpolationOf(bench)) !== "gouraud") {
            return { ok: false, say: { en: "Stay with Gouraud for this one.", it: "Per questa prova resta con Gouraud." } };
          }
          const share = (await highlightPeak(bench)) / (await highlightPeak(bench.with([["shading.interpolation", "phong"]])));
          const { triangles } = await bench.picture();
          return {
            ok: share >= 0.85,
            say: {
              en: `It has ${shown(100 * share, 0)} % with ${triangles} triangles.`,
              it: `Forza: ${shown(100 * share, 0)} %, con ${triangles} triangoli.`,
            },
          };
        },
        hint: {
          en: "The segments of the ball are on the Material tab, under its object. Try 32, then 48, then far more.",
          it: "I segmenti della palla sono nella scheda Materiale, sotto l’oggetto. Prova 32, poi 48, poi molti di più.",
        },
        because: {
          en: "Thousands of triangles for one white spot. And when the ball or the lamp moves, it twinkles as vertices pass through it.",
          it: "Migliaia di triangoli per una macchia bianca. E se la palla o la lampada si muovono, tremola al passaggio dei vertici.",
        },
        solution: { kind: "change", changes: [["objects[0].mesh", "primitive:sphere:128"]] },
      },
    },
    {
      title: { en: "Once a pixel", it: "Una volta per pixel" },
      text: {
        en: "Phong turned it round: do not interpolate the colour, interpolate the **normal**, make it unit again, and ask the equation at every pixel. The ball has 12 segments again. In 1975 that was far too slow; today every phone does it.",
        it: "Phong rovesciò l'idea: non interpolare il colore, interpola la **normale**, riportala a lunghezza 1 e calcola l'equazione in ogni pixel. La palla ha di nuovo 12 segmenti. Nel 1975 era troppo lento; oggi lo fa ogni telefono.",
      },
      formula: "\\mathbf n = \\frac{\\lambda_0 \\mathbf n_0 + \\lambda_1 \\mathbf n_1 + \\lambda_2 \\mathbf n_2}{|\\ldots|}",
      scene: [["objects[0].mesh", "primitive:sphere:12"]],
      control: { tab: "shading", testid: "option-shading-interpolation" },
      ask: {
        kind: "task",
        text: { en: "Choose Phong as the interpolation.", it: "Scegli Phong come interpolazione." },
        check: async (bench) => {
          if ((await interpolationOf(bench)) !== "phong") {
            return { ok: false };
          }
          const peak = await highlightPeak(bench);
          return {
            ok: true,
            say: {
              en: `The highlight's peak is ${shown(peak)}, with 12 segments.`,
              it: `Il massimo del riflesso è ${shownItalian(peak)}, con 12 segmenti.`,
            },
          };
        },
        hint: { en: "Interpolation, on the Shading tab.", it: "Interpolazione, nella scheda Ombreggiatura." },
        because: {
          en: "Full strength and round. Only the outline still tells the coarse mesh: normals bend light, they do not bend edges.",
          it: "Piena forza, e rotondo. Solo il contorno tradisce la mesh grossolana: le normali piegano la luce, non i bordi.",
        },
        solution: { kind: "change", changes: [["shading.interpolation", "phong"]] },
      },
    },
    {
      title: { en: "Question: the spot on the floor", it: "Domanda: il faretto sul pavimento" },
      text: {
        en: "A spotlight shines on the middle of a floor. The floor is a square of two triangles: four vertices, at its corners. The interpolation is Phong.",
        it: "Un faretto illumina il centro di un pavimento. Il pavimento è un quadrato di due triangoli: quattro vertici, agli angoli. L'interpolazione è Phong.",
      },
      scene: [
        ["camera", { eye: [0, 3.4, 5.4], target: [0, 0, 0], fov: 42 }],
        ["shading.interpolation", "phong"],
        ["ambient", [0.05, 0.05, 0.05]],
        ["lights", [{ type: "spot", position: [0, 3, 0], direction: [0, -1, 0], cutoff: 22, beam: 16 }]],
        ["objects", [kFloor]],
      ],
      ask: {
        kind: "choice",
        text: {
          en: "What becomes of the circle of light when the interpolation is Gouraud?",
          it: "Che cosa diventa il cerchio di luce con l'interpolazione Gouraud?",
        },
        options: [
          {
            text: { en: "It becomes a square", it: "Diventa un quadrato" },
            reply: {
              en: "A square would need vertices along its border. Where are the four that there are?",
              it: "Un quadrato vorrebbe vertici lungo il bordo. Dove sono i quattro che ci sono?",
            },
          },
          {
            text: { en: "It becomes a soft blur", it: "Diventa una macchia sfumata" },
            reply: {
              en: "A blur would be spread from bright vertices. Which vertex is in the cone?",
              it: "Una sfumatura partirebbe da vertici chiari. Quale vertice è nel cono?",
            },
          },
          { text: { en: "It vanishes altogether", it: "Sparisce del tutto" }, reply: { en: "", it: "" } },
          {
            text: { en: "It stays as it is", it: "Resta com'è" },
            reply: {
              en: "For that the middle of the floor would have to be evaluated. Gouraud asks at the vertices only.",
              it: "Per questo bisognerebbe calcolare il centro del pavimento. Gouraud calcola solo nei vertici.",
            },
          },
        ],
        answer: async (bench) => {
          const lit = (interpolated: string) =>
            bench.with([
              ["shading.interpolation", interpolated],
              ["shading.terms", ["diffuse"]],
              ["image.background", [0, 0, 0]],
            ]);
          const [gouraud, smooth] = [brightest(await lit("gouraud").picture()).value, brightest(await lit("phong").picture()).value];
          return gouraud < 0.01 ? 2 : gouraud > 0.9 * smooth ? 3 : 1;
        },
        because: {
          en: "No vertex stands in the light, so for Gouraud there is none. Games of the nineties cut their floors into many squares for this very reason.",
          it: "Nessun vertice è nella luce, quindi per Gouraud la luce non c'è. Proprio per questo i giochi degli anni Novanta dividevano i pavimenti in tanti quadrati.",
        },
      },
      reveal: { scene: [["shading.interpolation", "gouraud"]] },
    },
  ],
};
