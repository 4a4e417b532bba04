// Lesson 2: Lambert's law (docs/theory/lighting-equation.md; Lambert, Photometria, 1760).
import type { Vec3 } from "../../engine/types";
import { arcCosine, cameraTurn, placeOnBall, shown, shownItalian, type Bench } from "../bench";
import type { Lesson, Verdict } from "../lesson";
import { dot, scaled, subtract, unit } from "../../stage/vector";

const kNothingPicked: Verdict = {
  ok: false,
  say: { en: "Click a place on the ball.", it: "Fai clic su un punto della palla." },
};

/** A check of N.L at the chosen pixel. */
const picked =
  (isRight: (nDotL: number) => boolean) =>
  async (bench: Bench): Promise<Verdict> => {
    const reading = await bench.picked();
    if (!reading?.light) {
      return bench.hasPicked() ? { ok: false, say: { en: "That is the background.", it: "Quello è lo sfondo." } } : kNothingPicked;
    }
    const { n_dot_l } = reading.light;
    const angle = arcCosine(n_dot_l);
    return {
      ok: isRight(n_dot_l),
      say: {
        en: `Here $\\mathbf N\\cdot\\mathbf L$ is ${shown(n_dot_l)}: ${shown(angle, 0)}° lie between them.`,
        it: `Qui $\\mathbf N\\cdot\\mathbf L$ vale ${shownItalian(n_dot_l)}: tra i due ci sono ${shown(angle, 0)}°.`,
      },
    };
  };

const kEyeMark: Vec3 = [0.2, 0.6, 0.7746];
const kQuestionMark: Vec3 = [-0.1, 0.45, 0.8874];

export const lambert: Lesson = {
  id: "lambert",
  title: { en: "Lambert's law", it: "La legge di Lambert" },
  about: { en: "Why a tilted surface is darker", it: "Perché una superficie inclinata è più scura" },
  scene: {
    image: { background: [0.06, 0.07, 0.09] },
    camera: { view: "front" },
    shading: { lighting: "lambert", interpolation: "phong" },
    ambient: [0, 0, 0],
    lights: [{ type: "directional", direction: [-0.6, -0.48, -0.64] }],
    objects: [{ name: "ball", mesh: "primitive:sphere:96", material: { ambient: [0, 0, 0], diffuse: [0.85, 0.8, 0.7] } }],
  },
  steps: [
    {
      title: { en: "A tilted surface catches less", it: "Una superficie inclinata riceve meno" },
      text: {
        en: "A plaster ball in sunlight. Each place has a **normal** $\\mathbf N$, which stands upright on the surface, and a direction $\\mathbf L$ to the light. The more they part, the larger the patch over which the same beam is spread: the light on each spot goes with the cosine of the angle, and the cosine of two unit vectors is their dot product. Johann Heinrich Lambert, 1760.",
        it: "Una palla di gesso al sole. Ogni punto ha una **normale** $\\mathbf N$, perpendicolare alla superficie, e una direzione $\\mathbf L$ verso la luce. Più le due divergono, più ampia è la zona su cui si sparge lo stesso fascio: la luce che tocca a ogni punto va con il coseno dell'angolo, e il coseno tra due vettori unitari è il loro prodotto scalare. Johann Heinrich Lambert, 1760.",
      },
      formula: "I = k_d\\, l_d\\, \\max(\\mathbf N\\cdot\\mathbf L,\\, 0)",
      control: { tab: "explain", testid: "tab-explain" },
      ask: {
        kind: "task",
        text: {
          en: "Click the brightest place of the ball. The Explain tab shows its numbers.",
          it: "Fai clic sul punto più luminoso della palla. La scheda Spiega ne mostra i numeri.",
        },
        check: picked((cosine) => cosine >= 0.97),
        hint: { en: "The light comes from the upper right and from behind you.", it: "La luce viene da destra in alto e da dietro di te." },
        because: {
          en: "Where $\\mathbf N$ points at the light the cosine is 1: this is the most that a matte surface can do.",
          it: "Dove $\\mathbf N$ punta alla luce il coseno vale 1: di più una superficie opaca non può.",
        },
        solution: { kind: "pick", at: (bench) => placeOnBall(bench, 0) },
      },
    },
    {
      title: { en: "Half as bright", it: "Metà della luce" },
      text: {
        en: "From the brightest place to the edge of the shadow it is a quarter of the way around, 90°. Half of the light must lie somewhere in between. In the middle?",
        it: "Dal punto più luminoso al bordo dell'ombra c'è un quarto di giro, 90°. Da qualche parte in mezzo la luce è la metà. A metà strada?",
      },
      formula: "\\mathbf N\\cdot\\mathbf L = \\tfrac12",
      ask: {
        kind: "task",
        text: {
          en: "Click a place where the light is half of the brightest: $\\mathbf N\\cdot\\mathbf L$ from 0.46 to 0.54.",
          it: "Fai clic dove la luce è metà della massima: $\\mathbf N\\cdot\\mathbf L$ tra 0,46 e 0,54.",
        },
        check: picked((cosine) => cosine >= 0.46 && cosine <= 0.54),
        hint: {
          en: "Go from the brightest place towards the shadow and read the value on the way.",
          it: "Parti dal punto più luminoso verso l'ombra e leggi il valore lungo la strada.",
        },
        because: {
          en: "60°, not 45°: a cosine falls slowly at first, then fast. At 45° there are still 71 % of the light.",
          it: "60°, non 45°: il coseno scende piano all'inizio, poi in fretta. A 45° c'è ancora il 71 % della luce.",
        },
        solution: { kind: "pick", at: (bench) => placeOnBall(bench, 60) },
      },
    },
    {
      title: { en: "Beyond the horizon", it: "Oltre l'orizzonte" },
      text: {
        en: "Past 90° the light stands below the horizon of the surface, and the cosine becomes negative. A lamp cannot take light away, so the equation has $\\max(\\ldots, 0)$.",
        it: "Oltre i 90° la luce è sotto l'orizzonte della superficie, e il coseno diventa negativo. Una lampada non può togliere luce, perciò nell'equazione c'è $\\max(\\ldots, 0)$.",
      },
      formula: "\\max(\\mathbf N\\cdot\\mathbf L,\\, 0)",
      ask: {
        kind: "task",
        text: {
          en: "Click a place where $\\mathbf N\\cdot\\mathbf L$ is less than −0.2.",
          it: "Fai clic dove $\\mathbf N\\cdot\\mathbf L$ è minore di −0,2.",
        },
        check: picked((cosine) => cosine < -0.2),
        hint: {
          en: "At the lower left the ball turns away from the light.",
          it: "In basso a sinistra la palla volta le spalle alla luce.",
        },
        because: {
          en: "Explain shows the negative cosine, and 0 as its diffuse light. The line between is called the terminator, on balls and on planets.",
          it: "Spiega mostra il coseno negativo, e 0 come luce diffusa. La linea di confine si chiama terminatore, sulle palle e sui pianeti.",
        },
        solution: {
          kind: "pick",
          at: async (bench) => {
            const { lights, view } = await bench.picture();
            const eye = unit(view.eye);
            const light = unit(scaled(lights[0]!.direction, -1));
            const across = unit(subtract(light, scaled(eye, dot(eye, light))));
            return unit([0, 1, 2].map((i) => eye[i]! * 0.5 - across[i]! * 0.866) as Vec3);
          },
        },
      },
    },
    {
      title: { en: "The eye does not matter", it: "L'occhio non conta" },
      text: {
        en: "There is no direction to the eye in Lambert's law: a matte surface sends the light that it catches evenly to all sides. Walk around the ball, and A keeps its brightness.",
        it: "Nella legge di Lambert la direzione verso l'occhio non c'è: una superficie opaca rimanda la luce che riceve allo stesso modo da ogni parte. Gira attorno alla palla: A conserva la sua luminosità.",
      },
      marks: [{ letter: "A", at: kEyeMark }],
      control: { tab: "camera", testid: "tab-camera" },
      ask: {
        kind: "task",
        text: {
          en: "Turn the camera by at least 25°, by dragging the picture or with the arrow keys.",
          it: "Gira la camera di almeno 25°, trascinando l'immagine o con i tasti freccia.",
        },
        check: async (bench) => {
          const turn = await cameraTurn(bench);
          const [before, now] = await Promise.all([bench.before().at(kEyeMark), bench.at(kEyeMark)]);
          if (turn < 25 || !before || !now) {
            return { ok: turn >= 25, say: { en: `${shown(turn, 0)}° so far.`, it: `Finora ${shown(turn, 0)}°.` } };
          }
          const [was, is] = [before.shading.diffuse[0], now.shading.diffuse[0]];
          return {
            ok: true,
            say: {
              en: `You turned by ${shown(turn, 0)}°. The red of A was ${shown(was)} and is ${shown(is)}.`,
              it: `Hai girato di ${shown(turn, 0)}°. Il rosso di A era ${shownItalian(was)} ed è ${shownItalian(is)}.`,
            },
          };
        },
        hint: {
          en: "Drag across the picture; or choose the picture and press an arrow key a few times.",
          it: "Trascina sull'immagine; oppure scegli l'immagine e premi più volte un tasto freccia.",
        },
        because: {
          en: "Not all that looks matte obeys. The full Moon is as bright at its rim as in its middle: its dust does not follow Lambert, and so the Moon looks like a disk.",
          it: "Non tutto ciò che sembra opaco obbedisce. La Luna piena è chiara al bordo quanto al centro: la sua polvere non segue Lambert, e per questo sembra un disco.",
        },
        solution: { kind: "change", changes: [["camera", { view: "three-quarter" }]] },
      },
    },
    {
      title: { en: "Question: how steep?", it: "Domanda: quanto è inclinata?" },
      text: {
        en: "The sun has moved on. Choose A, by a click or with the button, and read $\\mathbf N\\cdot\\mathbf L$ in Explain.",
        it: "Il sole si è spostato. Scegli A, con un clic o con il pulsante, e leggi $\\mathbf N\\cdot\\mathbf L$ in Spiega.",
      },
      scene: [["lights[0].direction", [-0.75, -0.3, -0.55]]],
      marks: [{ letter: "A", at: kQuestionMark }],
      control: { tab: "explain", testid: "tab-explain" },
      ask: {
        kind: "number",
        text: {
          en: "How many degrees lie between $\\mathbf N$ and $\\mathbf L$ at A?",
          it: "Quanti gradi ci sono tra $\\mathbf N$ e $\\mathbf L$ in A?",
        },
        unit: "°",
        answer: async (bench) => arcCosine((await bench.at(kQuestionMark))!.light!.n_dot_l),
        tolerance: { absolute: 2.5 },
        slips: [
          {
            fits: (given, answer) => Math.abs(given - Math.cos((answer * Math.PI) / 180)) < 0.03,
            say: { en: "That is the cosine itself. The angle is its arc cosine.", it: "Questo è il coseno. L'angolo è il suo arcocoseno." },
          },
          {
            fits: (given, answer) => Math.abs(given - (answer * Math.PI) / 180) < 0.03,
            say: { en: "That is right in radians: times 180/π.", it: "In radianti è giusto: moltiplica per 180/π." },
          },
          {
            fits: (given, answer) => Math.abs(given - (90 - answer)) < 2.5,
            say: {
              en: "That is how high the light stands above the surface. The angle from the normal is 90° minus that.",
              it: "Questa è l'altezza della luce sulla superficie. L'angolo dalla normale è 90° meno questo.",
            },
          },
        ],
        hint: {
          en: "The cosine of the angle is $\\mathbf N\\cdot\\mathbf L$; the inverse is on your calculator as cos⁻¹.",
          it: "Il coseno dell'angolo è $\\mathbf N\\cdot\\mathbf L$; l'inverso sulla calcolatrice è cos⁻¹.",
        },
        because: {
          en: "So one number in a pixel tells how the surface is tilted against the light. Shape from shading works that way round.",
          it: "Così un solo numero di un pixel dice com'è inclinata la superficie rispetto alla luce. Lo *shape from shading* fa proprio questo.",
        },
      },
    },
  ],
};
