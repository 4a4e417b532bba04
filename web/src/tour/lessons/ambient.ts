// Lesson 1: ambient light, the term without a direction (docs/theory/lighting-equation.md).
import type { Vec3 } from "../../engine/types";
import { brightest, shown, shownItalian, type Bench } from "../bench";
import type { Lesson } from "../lesson";

const kBright: Vec3 = [0.204, 1.919, 1.68];
const kDark: Vec3 = [1.83, 1.292, 0.581];

async function channelMaximum(bench: Bench): Promise<number> {
  const dark = bench.with([["image.background", [0, 0, 0]]]);
  return brightest(await dark.picture()).value;
}

/** Different colours among the pixels that the scene covers. */
async function colorsOf(bench: Bench): Promise<number> {
  const { floats } = await bench.with([["image.background", [0, 0, 0, 0]]]).picture();
  const colors = new Set<string>();
  for (let i = 0; i < floats!.length; i += 4) {
    if (floats![i + 3] === 1) {
      colors.add(`${floats![i]} ${floats![i + 1]} ${floats![i + 2]}`);
    }
  }
  return colors.size;
}

/** How many times brighter the lit side is than the dark one. */
async function contrast(bench: Bench): Promise<number> {
  const [bright, dark] = await Promise.all([bench.at(kBright), bench.at(kDark)]);
  const value = (reading: typeof bright): number => (reading ? reading.explanation.color[0] : 0);
  return value(bright) / Math.max(1e-6, value(dark));
}

export const ambient: Lesson = {
  id: "ambient",
  title: { en: "Ambient light", it: "La luce ambiente" },
  about: { en: "Light from everywhere, and what it cannot show", it: "Luce da ogni parte, e ciò che non può mostrare" },
  scene: {
    image: { background: [0.06, 0.07, 0.09] },
    camera: { view: "three-quarter" },
    shading: { lighting: "phong", interpolation: "phong" },
    ambient: [0, 0, 0],
    lights: [],
    objects: [{ name: "teapot", mesh: "primitive:teapot", material: { ambient: [0.8, 0.36, 0.16], diffuse: [0.8, 0.36, 0.16] } }],
  },
  steps: [
    {
      title: { en: "No light, no picture", it: "Senza luce, nessuna immagine" },
      text: {
        en: "There is a teapot here: it hides the background. No lamp shines, so every sum in the lighting equation is 0. The simplest light of all comes from no place in particular: **ambient light**, with the colour $I_a$. The material answers with its own colour $k_a$, and both are multiplied, channel by channel.",
        it: "Qui c'è una teiera: nasconde lo sfondo. Nessuna lampada è accesa, quindi ogni somma dell'equazione d'illuminazione vale 0. La luce più semplice di tutte non viene da nessun luogo preciso: è la **luce ambiente**, di colore $I_a$. Il materiale risponde con il proprio colore $k_a$, e i due si moltiplicano, canale per canale.",
      },
      formula: "I = k_a\\, I_a",
      control: { tab: "lights", testid: "option-ambient" },
      ask: {
        kind: "task",
        text: {
          en: "Raise the scene's ambient light until the teapot can be seen well.",
          it: "Alza la luce ambiente della scena finché la teiera si vede bene.",
        },
        check: async (bench) => {
          const value = await channelMaximum(bench);
          return {
            ok: value >= 0.25,
            say: { en: `Its brightest channel is now ${shown(value)}.`, it: `Il suo canale più chiaro ora vale ${shownItalian(value)}.` },
          };
        },
        hint: {
          en: "The ambient light is a colour of the scene, on the Lights tab. A mid gray is enough.",
          it: "La luce ambiente è un colore della scena, nella scheda Luci. Basta un grigio medio.",
        },
        because: {
          en: "One number a channel, $k_a I_a$: this is the whole term. It needs no lamp and casts no shadow.",
          it: "Un numero per canale, $k_a I_a$: il termine è tutto qui. Non chiede lampade e non getta ombre.",
        },
        solution: { kind: "change", changes: [["ambient", [0.5, 0.5, 0.5]]] },
      },
    },
    {
      title: { en: "A paper silhouette", it: "Una sagoma di carta" },
      text: {
        en: "Where does the spout end and the body begin? Drag the picture to turn the teapot: handle, lid and body run into each other. Neither the normal $\\mathbf N$ nor a direction stands in $k_a I_a$.",
        it: "Dove finisce il beccuccio e comincia il corpo? Trascina l'immagine per girare la teiera: manico, coperchio e corpo si confondono. In $k_a I_a$ non compare né la normale $\\mathbf N$ né una direzione.",
      },
      formula: "I = k_a\\, I_a",
      scene: [["ambient", [0.5, 0.5, 0.5]]],
      ask: {
        kind: "choice",
        text: {
          en: "How many different colours does the surface of the teapot have in this picture?",
          it: "Quanti colori diversi ha la superficie della teiera in questa immagine?",
        },
        options: [
          {
            text: { en: "Hundreds: it is round", it: "Centinaia: è rotonda" },
            reply: {
              en: "Roundness would have to come in through $\\mathbf N$, and there is no $\\mathbf N$ in this term.",
              it: "La rotondità dovrebbe entrare con $\\mathbf N$, e in questo termine $\\mathbf N$ non c'è.",
            },
          },
          { text: { en: "One", it: "Uno solo" }, reply: { en: "", it: "" } },
          {
            text: { en: "Two: a lit and a dark side", it: "Due: un lato chiaro e uno scuro" },
            reply: {
              en: "A dark side needs a lamp on the other one. Ambient light comes from everywhere.",
              it: "Un lato scuro vuole una lampada sull'altro. La luce ambiente viene da ogni parte.",
            },
          },
        ],
        answer: async (bench) => {
          const colors = await colorsOf(bench);
          return colors === 1 ? 1 : colors === 2 ? 2 : 0;
        },
        because: {
          en: "One. Ambient light alone tells where something is, never what shape it has.",
          it: "Uno solo. La luce ambiente da sola dice dove c'è qualcosa, mai che forma ha.",
        },
      },
    },
    {
      title: { en: "What it is good for", it: "A che cosa serve" },
      text: {
        en: "Now a lamp shines from the left, and the ambient light is off: what the lamp does not reach is black. In a room it never is, since walls and table send light on. Following that light is work for a path tracer; the ambient term puts one constant in its place.",
        it: "Ora una lampada illumina da sinistra e la luce ambiente è spenta: ciò che la lampada non raggiunge è nero. In una stanza non lo è mai, perché pareti e tavolo rimandano la luce. Seguire quella luce è lavoro da path tracer; il termine ambiente la sostituisce con una costante.",
      },
      scene: [
        ["ambient", [0, 0, 0]],
        ["lights", [{ type: "directional", direction: [0.8, -0.5, -0.6] }]],
      ],
      marks: [
        { letter: "A", at: kBright },
        { letter: "B", at: kDark },
      ],
      control: { tab: "lights", testid: "option-ambient" },
      ask: {
        kind: "task",
        text: {
          en: "Lighten the dark side without drowning the lamp: A shall be 4 to 10 times as bright as B.",
          it: "Schiarisci il lato scuro senza annegare la lampada: A deve essere da 4 a 10 volte più luminoso di B.",
        },
        check: async (bench) => {
          const ratio = await contrast(bench);
          if (ratio > 1000) {
            return { ok: false, say: { en: "B gets no light at all yet.", it: "B non riceve ancora luce." } };
          }
          return {
            ok: ratio >= 4 && ratio <= 10,
            say: { en: `A is ${shown(ratio, 1)} times as bright as B.`, it: `A è ${shownItalian(ratio, 1)} volte più luminoso di B.` },
          };
        },
        hint: {
          en: "Little is enough: try an ambient light around 0.15. If A cannot be seen, frame the teapot again.",
          it: "Ne basta poca: prova con una luce ambiente intorno a 0,15. Se A non si vede, inquadra di nuovo la teiera.",
        },
        because: {
          en: "Ambient light is added on the lit side as well; a lot of it makes everything flat. Few scenes want more than 0.2.",
          it: "La luce ambiente si aggiunge anche sul lato illuminato; se è tanta appiattisce tutto. Poche scene ne vogliono più di 0,2.",
        },
        solution: { kind: "change", changes: [["ambient", [0.15, 0.15, 0.15]]] },
      },
    },
    {
      title: { en: "Question: red light on green", it: "Domanda: luce rossa sul verde" },
      text: {
        en: "The lamp is off again. The ambient light is white, $I_a = (0.5, 0.5, 0.5)$, and the teapot purely green, $k_a = (0, 0.8, 0)$. In a moment the light will turn purely red, $I_a = (0.5, 0, 0)$.",
        it: "La lampada è di nuovo spenta. La luce ambiente è bianca, $I_a = (0{,}5;\\ 0{,}5;\\ 0{,}5)$, e la teiera puramente verde, $k_a = (0;\\ 0{,}8;\\ 0)$. Tra poco la luce diventerà puramente rossa, $I_a = (0{,}5;\\ 0;\\ 0)$.",
      },
      formula: "I = k_a\\, I_a",
      scene: [
        ["ambient", [0.5, 0.5, 0.5]],
        ["lights", []],
        ["objects[0].material", { ambient: [0, 0.8, 0], diffuse: [0, 0.8, 0] }],
      ],
      ask: {
        kind: "choice",
        text: { en: "Which colour will the teapot have under the red light?", it: "Di che colore sarà la teiera sotto la luce rossa?" },
        options: [
          {
            text: { en: "Yellow: red and green together", it: "Gialla: rosso e verde insieme" },
            reply: {
              en: "Two lights add up to yellow, a red one and a green one. Light and material do not add up, they multiply.",
              it: "Due luci si sommano in giallo, una rossa e una verde. Luce e materiale non si sommano: si moltiplicano.",
            },
          },
          {
            text: { en: "Dark red", it: "Rosso scuro" },
            reply: {
              en: "The light is red, but what of red does this material send back? $k_a$ is 0 there.",
              it: "La luce è rossa, ma quanto rosso rimanda questo materiale? Lì $k_a$ vale 0.",
            },
          },
          {
            text: { en: "Green, a little darker", it: "Verde, un po' più scura" },
            reply: {
              en: "It could only send green back if some green arrived.",
              it: "Potrebbe rimandare verde solo se un po' di verde arrivasse.",
            },
          },
          { text: { en: "Black", it: "Nera" }, reply: { en: "", it: "" } },
        ],
        answer: async (bench) => {
          const { explanation } = (await bench.with([["ambient", [0.5, 0, 0]]]).at(kBright))!;
          const [red, green] = explanation.color.map((channel) => channel > 0.01);
          return red && green ? 0 : red ? 1 : green ? 2 : 3;
        },
        because: {
          en: "Black: $(0.5 \\cdot 0,\\ 0 \\cdot 0.8,\\ 0 \\cdot 0)$. Every term of the equation multiplies light and material so, which is why colours look odd under coloured lamps.",
          it: "Nera: $(0{,}5 \\cdot 0;\\ 0 \\cdot 0{,}8;\\ 0 \\cdot 0)$. Ogni termine dell'equazione moltiplica così luce e materiale: ecco perché sotto lampade colorate i colori appaiono strani.",
        },
      },
      reveal: { scene: [["ambient", [0.5, 0, 0]]] },
    },
  ],
};
