// Lesson 3: Phong's highlight (docs/theory/lighting-equation.md; Phong, Illumination for computer generated pictures, CACM 1975).
import type { Vec3 } from "../../engine/types";
import { angleBetween, arcCosine, cameraTurn, highlightPeak, highlightPlace, shown, shownItalian } from "../bench";
import type { Lesson } from "../lesson";

const kQuestionMark: Vec3 = [-0.1, 0.55, 0.829];

export const phong: Lesson = {
  id: "phong",
  title: { en: "Phong's highlight", it: "Il riflesso di Phong" },
  about: { en: "A mirror that is a little out of true", it: "Uno specchio un po' impreciso" },
  scene: {
    image: { background: [0.06, 0.07, 0.09] },
    camera: { view: "front" },
    shading: { lighting: "lambert", interpolation: "phong" },
    ambient: [0.12, 0.12, 0.12],
    lights: [{ type: "directional", direction: [-0.48, -0.6, -0.64] }],
    objects: [
      {
        name: "ball",
        mesh: "primitive:sphere:96",
        material: { ambient: [0.5, 0.06, 0.05], diffuse: [0.5, 0.06, 0.05], specular: [0.75, 0.75, 0.75], shininess: 25 },
      },
    ],
  },
  steps: [
    {
      title: { en: "From chalk to plastic", it: "Dal gesso alla plastica" },
      text: {
        en: "Lambert's law alone makes everything look like chalk. Bui Tuong Phong added one term in his thesis work, printed in 1975: a **highlight** around the direction in which a mirror would send the light.",
        it: "La sola legge di Lambert fa sembrare tutto di gesso. Bui Tuong Phong aggiunse un termine nel lavoro di dottorato, pubblicato nel 1975: un **riflesso** intorno alla direzione in cui uno specchio manderebbe la luce.",
      },
      formula:
        "\\begin{aligned} I ={}& k_a I_a + k_d\\, l_d \\max(\\mathbf N\\cdot\\mathbf L, 0) \\\\ &{}+ k_s\\, l_s \\max(\\mathbf R\\cdot\\mathbf V, 0)^n \\end{aligned}",
      control: { tab: "shading", testid: "option-shading-lighting" },
      ask: {
        kind: "task",
        text: { en: "Choose the lighting model Phong.", it: "Scegli il modello d'illuminazione Phong." },
        check: async (bench) => {
          const model = (await bench.at([0, 0, 1]))?.fragment.lighting;
          if (model === "blinn-phong" || model === "ggx") {
            return { ok: false, say: { en: "That one is younger. Phong's came first.", it: "Quello è più giovane. Il primo fu Phong." } };
          }
          return { ok: model === "phong" && (await highlightPeak(bench)) > 0.3 };
        },
        hint: {
          en: "It is the first control of the Shading tab; the specular term must be on.",
          it: "È il primo comando della scheda Ombreggiatura; il termine speculare dev'essere acceso.",
        },
        because: {
          en: "One white spot, and the same ball is plastic. Nothing about its shape or its colour has changed.",
          it: "Una macchia bianca, e la stessa palla è di plastica. Forma e colore non sono cambiati.",
        },
        solution: { kind: "change", changes: [["shading.lighting", "phong"]] },
      },
    },
    {
      title: { en: "Where a mirror would send it", it: "Dove lo manderebbe uno specchio" },
      text: {
        en: "$\\mathbf R$ is $\\mathbf L$ thrown to the other side of the normal. $\\mathbf V$ points to your eye. The closer $\\mathbf R$ comes to $\\mathbf V$, the more of the mirrored light you see; the power $n$ says how fast it fades.",
        it: "$\\mathbf R$ è $\\mathbf L$ ribaltato dall'altra parte della normale. $\\mathbf V$ punta al tuo occhio. Più $\\mathbf R$ si avvicina a $\\mathbf V$, più luce riflessa vedi; la potenza $n$ dice quanto in fretta svanisce.",
      },
      formula: "\\mathbf R = 2(\\mathbf N\\cdot\\mathbf L)\\,\\mathbf N - \\mathbf L",
      scene: [["shading.lighting", "phong"]],
      control: { tab: "explain", testid: "tab-explain" },
      ask: {
        kind: "task",
        text: {
          en: "Click the middle of the highlight, and look at the arrows R and V.",
          it: "Fai clic al centro del riflesso e guarda le frecce R e V.",
        },
        check: async (bench) => {
          const reading = await bench.picked();
          if (!reading?.light) {
            return { ok: false, say: { en: "Click a place on the ball.", it: "Fai clic su un punto della palla." } };
          }
          const { r_dot_v } = reading.light;
          const angle = shown(arcCosine(r_dot_v), 0);
          return {
            ok: r_dot_v > 0.99,
            say: {
              en: `Here $\\mathbf R\\cdot\\mathbf V$ is ${shown(r_dot_v, 3)}: R and V are ${angle}° apart.`,
              it: `Qui $\\mathbf R\\cdot\\mathbf V$ vale ${shownItalian(r_dot_v, 3)}: tra R e V ci sono ${angle}°.`,
            },
          };
        },
        hint: { en: "The highlight is the white spot at the upper right.", it: "Il riflesso è la macchia bianca in alto a destra." },
        because: {
          en: "In the middle R and V are one. It is not the brightest place for Lambert: that one lies further towards the light.",
          it: "Al centro R e V coincidono. Non è il punto più luminoso per Lambert: quello è più vicino alla luce.",
        },
        solution: { kind: "pick", at: highlightPlace },
      },
    },
    {
      title: { en: "It follows you", it: "Ti segue" },
      text: {
        en: "Lambert's light did not care for the eye. The highlight does: $\\mathbf V$ stands in its formula. Watch it while you walk around the ball; the sun stays where it is.",
        it: "Alla luce di Lambert l'occhio non importava. Al riflesso sì: $\\mathbf V$ compare nella formula. Guardalo mentre giri intorno alla palla; il sole resta dov'è.",
      },
      formula: "k_s\\, l_s \\max(\\mathbf R\\cdot\\mathbf V,\\, 0)^n",
      control: { tab: "camera", testid: "tab-camera" },
      ask: {
        kind: "task",
        text: { en: "Turn the camera by at least 25°.", it: "Gira la camera di almeno 25°." },
        check: async (bench) => {
          const turn = await cameraTurn(bench);
          if (turn < 25) {
            return { ok: false, say: { en: `${shown(turn, 0)}° so far.`, it: `Finora ${shown(turn, 0)}°.` } };
          }
          if ((await highlightPeak(bench)) < 0.1) {
            return { ok: true, say: { en: "From here the highlight is out of sight.", it: "Da qui il riflesso non si vede più." } };
          }
          const moved = shown(angleBetween(await highlightPlace(bench), await highlightPlace(bench.before())), 0);
          return {
            ok: true,
            say: {
              en: `You turned by ${shown(turn, 0)}°, and the highlight moved by ${moved}° over the ball.`,
              it: `Hai girato di ${shown(turn, 0)}° e il riflesso si è spostato di ${moved}° sulla palla.`,
            },
          };
        },
        hint: { en: "Drag across the picture, or use the arrow keys on it.", it: "Trascina sull'immagine, o usa i tasti freccia." },
        because: {
          en: "About half of your turn: the highlight sits where the normal points midway between light and eye. Remember that midway, it comes back with Blinn.",
          it: "Circa la metà del tuo giro: il riflesso sta dove la normale punta a metà tra luce e occhio. Ricorda quella metà: tornerà con Blinn.",
        },
        solution: { kind: "change", changes: [["camera", { view: "three-quarter" }]] },
      },
    },
    {
      title: { en: "The colour of a highlight", it: "Il colore di un riflesso" },
      text: {
        en: "The ball is red, its highlight white: $k_s$ is a colour of its own. Plastic, lacquer and fruit mirror all colours alike, at their surface; red comes from below it. Metals have no below: they colour what they mirror.",
        it: "La palla è rossa, il riflesso bianco: $k_s$ è un colore a sé. Plastica, lacca e frutta riflettono in superficie tutti i colori allo stesso modo; il rosso viene da sotto. I metalli non hanno un sotto: colorano ciò che riflettono.",
      },
      formula: "k_s = (r, g, b)",
      control: { tab: "material", testid: "library" },
      ask: {
        kind: "task",
        text: {
          en: "Make the highlight a metal's: give the ball a metal from the library, or a coloured $k_s$.",
          it: "Fanne il riflesso di un metallo: dai alla palla un metallo della libreria, o un $k_s$ colorato.",
        },
        check: async (bench) => {
          const floats = (
            await bench
              .with([
                ["shading.terms", ["specular"]],
                ["image.background", [0, 0, 0]],
              ])
              .picture()
          ).floats!;
          let best = 0;
          for (let i = 0; i < floats.length; i += 4) {
            best = floats[i]! + floats[i + 1]! + floats[i + 2]! > floats[best]! + floats[best + 1]! + floats[best + 2]! ? i : best;
          }
          const [low, , high] = [floats[best]!, floats[best + 1]!, floats[best + 2]!].sort((a, b) => a - b);
          if (high! < 0.05) {
            return { ok: false, say: { en: "Now there is no highlight at all.", it: "Ora il riflesso non c'è più." } };
          }
          return { ok: high! > 1.3 * low! };
        },
        hint: { en: "On the Material tab choose gold, copper or brass.", it: "Nella scheda Materiale scegli oro, rame o ottone." },
        because: {
          en: "In Phong's own formula every highlight had the colour of the lamp, and for years computer pictures looked like plastic. Cook and Torrance showed the difference in 1982.",
          it: "Nella formula di Phong ogni riflesso aveva il colore della lampada, e per anni le immagini al computer sembrarono di plastica. Cook e Torrance mostrarono la differenza nel 1982.",
        },
        solution: { kind: "change", changes: [["objects[0].material", "gold"]] },
      },
    },
    {
      title: { en: "Question: how far is R from L?", it: "Domanda: quanto dista R da L?" },
      text: {
        en: "Plastic again. At A the light comes in at some angle from the normal, and the mirrored light leaves at the same angle on the other side.",
        it: "Di nuovo plastica. In A la luce arriva con un certo angolo dalla normale, e quella riflessa riparte con lo stesso angolo dall'altra parte.",
      },
      formula: "\\mathbf R = 2(\\mathbf N\\cdot\\mathbf L)\\,\\mathbf N - \\mathbf L",
      scene: [
        ["objects[0].material", { ambient: [0.5, 0.06, 0.05], diffuse: [0.5, 0.06, 0.05], specular: [0.75, 0.75, 0.75], shininess: 25 }],
      ],
      marks: [{ letter: "A", at: kQuestionMark }],
      control: { tab: "explain", testid: "tab-explain" },
      ask: {
        kind: "number",
        text: {
          en: "How many degrees lie between $\\mathbf L$ and $\\mathbf R$ at A? Explain has $\\mathbf N\\cdot\\mathbf L$.",
          it: "Quanti gradi ci sono tra $\\mathbf L$ e $\\mathbf R$ in A? Spiega mostra $\\mathbf N\\cdot\\mathbf L$.",
        },
        unit: "°",
        answer: async (bench) => {
          const { to_light, reflected } = (await bench.at(kQuestionMark))!.light!;
          return angleBetween(to_light, reflected);
        },
        tolerance: { absolute: 4 },
        slips: [
          {
            fits: (given, answer) => Math.abs(given - answer / 2) < 2.5,
            say: {
              en: "That is the angle between $\\mathbf N$ and $\\mathbf L$. $\\mathbf R$ lies as far on the other side.",
              it: "Questo è l'angolo tra $\\mathbf N$ e $\\mathbf L$. $\\mathbf R$ sta altrettanto lontano dall'altra parte.",
            },
          },
          {
            fits: (given) => given > 0 && given <= 1,
            say: { en: "That looks like a cosine. The question is for degrees.", it: "Sembra un coseno. La domanda chiede gradi." },
          },
        ],
        hint: {
          en: "First the angle of which $\\mathbf N\\cdot\\mathbf L$ is the cosine; then think of the mirror.",
          it: "Prima l'angolo di cui $\\mathbf N\\cdot\\mathbf L$ è il coseno; poi pensa allo specchio.",
        },
        because: {
          en: "Twice the angle from the normal. So when a surface tilts by 1°, the light that it mirrors swings by 2°.",
          it: "Il doppio dell'angolo dalla normale. Perciò se una superficie s'inclina di 1°, la luce che riflette ruota di 2°.",
        },
      },
    },
  ],
};
