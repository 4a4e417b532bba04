// Lesson 8: kinds of light, attenuation and spots (docs/theory/lights.md; OpenGL 2.1, 2.14.1).
import type { SceneObject, Vec3 } from "../../engine/types";
import { angleBetween, shown, shownItalian, type Bench, type Reading } from "../bench";
import type { Lesson, Text, Verdict } from "../lesson";
import { length, subtract } from "../../stage/vector";

const kFloor: SceneObject = {
  name: "floor",
  mesh: "primitive:plane",
  matrix: [5, 0, 0, 0, 0, 1, 0, 0, 0, 0, 5, 0, 0, 0, 0, 1],
  material: { ambient: [0.5, 0.48, 0.44], diffuse: [0.5, 0.48, 0.44] },
};
const kPost = (x: number): SceneObject => ({
  name: `ball ${x < 0 ? "left" : x > 0 ? "right" : "middle"}`,
  mesh: "primitive:sphere:48",
  material: { ambient: [0.5, 0.2, 0.08], diffuse: [0.5, 0.2, 0.08], specular: [0.4, 0.4, 0.4], shininess: 40 },
  matrix: [0.45, 0, 0, x, 0, 0.45, 0, 0.45, 0, 0, 0.45, -0.6, 0, 0, 0, 1],
});

const kNear: Vec3 = [-1.5, 0, 0.8];
const kFar: Vec3 = [1.5, 0, 0.8];
const kOutside: Vec3 = [2.25, 0, 0.8];
const kBelow: Vec3 = [0, 0, 0.8];

const kOutOfSight: Verdict = {
  ok: false,
  say: { en: "The marks are out of sight: frame the floor again.", it: "I segni non si vedono: inquadra di nuovo il pavimento." },
};

async function both(bench: Bench, a: Vec3, b: Vec3): Promise<[Reading, Reading] | undefined> {
  const [first, second] = await Promise.all([bench.at(a), bench.at(b)]);
  return first?.light && second?.light ? [first, second] : undefined;
}

/** Some place between two is in the soft rim of the spot. */
async function hasSoftRim(bench: Bench, from: Vec3, to: Vec3): Promise<boolean> {
  for (let i = 0; i <= 24; ++i) {
    const t = i / 24;
    const reading = await bench.at([from[0] + (to[0] - from[0]) * t, 0, from[2] + (to[2] - from[2]) * t]);
    const spot = reading?.light?.spot ?? 0;
    if (spot > 0.05 && spot < 0.95) {
      return true;
    }
  }
  return false;
}

const kOneLamp: Text = { en: "Leave one lamp alone in the scene.", it: "Lascia una sola lampada nella scena." };

export const lights: Lesson = {
  id: "lights",
  title: { en: "Lights and distance", it: "Luci e distanza" },
  about: { en: "Sun, lamp and spot, and why light thins out", it: "Sole, lampada e faretto, e perché la luce si dirada" },
  scene: {
    image: { background: [0.05, 0.06, 0.08] },
    camera: { eye: [0, 3.8, 9.6], target: [0, 0.5, 0], fov: 42 },
    shading: { lighting: "phong", interpolation: "phong" },
    ambient: [0.06, 0.06, 0.06],
    lights: [{ type: "directional", name: "lamp", position: [-1.5, 1.6, 0.8], direction: [0.2, -1, -0.5] }],
    objects: [kFloor, kPost(-1.5), kPost(0), kPost(1.5)],
  },
  steps: [
    {
      title: { en: "Sun or lamp", it: "Sole o lampada" },
      text: {
        en: "A **directional** light is the sun: so far away that $\\mathbf L$ is the same everywhere. A **point** light stands somewhere in the scene, and each place sees it in another direction.",
        it: "Una luce **direzionale** è il sole: così lontano che $\\mathbf L$ è lo stesso ovunque. Una luce **puntiforme** sta da qualche parte nella scena, e ogni punto la vede in un'altra direzione.",
      },
      marks: [
        { letter: "A", at: kNear },
        { letter: "B", at: kFar },
      ],
      control: { tab: "lights", testid: "option-lights-type" },
      ask: {
        kind: "task",
        text: { en: "Make the light a point light.", it: "Fai della luce una luce puntiforme." },
        check: async (bench) => {
          const { lights } = await bench.picture();
          if (lights.length !== 1) {
            return { ok: false, say: kOneLamp };
          }
          if (lights[0]!.type !== "point") {
            return { ok: false };
          }
          const readings = await both(bench, kNear, kFar);
          if (!readings) {
            return { ok: true };
          }
          const apart = shown(angleBetween(readings[0].light!.to_light, readings[1].light!.to_light), 0);
          return {
            ok: true,
            say: { en: `At A and at B, L now points ${apart}° apart.`, it: `In A e in B, ora L differisce di ${apart}°.` },
          };
        },
        hint: { en: "The kind of light is on the Lights tab.", it: "Il tipo di luce è nella scheda Luci." },
        because: {
          en: "The floor darkens away from the lamp, but only since the light comes in flatter there. Nothing thins it out yet.",
          it: "Il pavimento si scurisce lontano dalla lampada, ma solo perché lì la luce arriva più radente. Niente ancora la dirada.",
        },
        solution: { kind: "change", changes: [["lights[0].type", "point"]] },
      },
    },
    {
      title: { en: "Light thins out", it: "La luce si dirada" },
      text: {
        en: "Light from a lamp spreads over spheres, and their area grows with $d^2$. OpenGL divides by a polynomial that can be tuned to taste; its default $c = 1$, $l = q = 0$ is no attenuation at all.",
        it: "La luce di una lampada si sparge su sfere, la cui area cresce con $d^2$. OpenGL divide per un polinomio regolabile a piacere; il suo valore predefinito, $c = 1$, $l = q = 0$, non attenua affatto.",
      },
      formula: "f = \\frac{1}{c + l\\,d + q\\,d^2} \\qquad f = \\frac{1}{d^{\\,p}}",
      scene: [["lights[0].type", "point"]],
      marks: [
        { letter: "A", at: kNear },
        { letter: "B", at: kFar },
      ],
      control: { tab: "lights", testid: "option-lights-attenuation-falloff" },
      ask: {
        kind: "task",
        text: {
          en: "Give the lamp an attenuation with which B keeps less than a third of A's share $f$.",
          it: "Dai alla lampada un'attenuazione con cui a B resti meno di un terzo della quota $f$ di A.",
        },
        check: async (bench) => {
          const readings = await both(bench, kNear, kFar);
          if (!readings) {
            return kOutOfSight;
          }
          const [a, b] = readings.map(({ light }) => light!.attenuation);
          return {
            ok: b! < a! / 3,
            say: { en: `f is ${shown(a!)} at A and ${shown(b!)} at B.`, it: `f vale ${shownItalian(a!)} in A e ${shownItalian(b!)} in B.` },
          };
        },
        hint: {
          en: "A power $p$ of 2 is what light does; or raise the quadratic factor $q$.",
          it: "Una potenza $p$ di 2 è ciò che fa la luce; oppure alza il fattore quadratico $q$.",
        },
        because: {
          en: "Twice the distance, a quarter of the light. With a power, colours are stated as they arrive at distance 1.",
          it: "Doppia distanza, un quarto della luce. Con una potenza i colori sono quelli che arrivano a distanza 1.",
        },
        solution: { kind: "change", changes: [["lights[0].attenuation", { falloff: 2 }]] },
      },
    },
    {
      title: { en: "The cone", it: "Il cono" },
      text: {
        en: "A **spot** is a point light with a cone: outside of its half angle, the cutoff, there is no light. The lamp now hangs above the middle and looks straight down.",
        it: "Un **faretto** è una luce puntiforme con un cono: oltre il suo semiangolo, il cutoff, non c'è luce. La lampada ora pende sopra il centro e guarda dritto in giù.",
      },
      formula: "\\cos\\theta < \\cos\\theta_{\\text{cutoff}} \\;\\Rightarrow\\; s = 0",
      scene: [["lights", [{ type: "spot", name: "lamp", position: [0, 3, 0.8], direction: [0, -1, 0], cutoff: 12 }]]],
      marks: [
        { letter: "A", at: kNear },
        { letter: "B", at: kFar },
        { letter: "C", at: kOutside },
      ],
      control: { tab: "lights", testid: "option-lights-cutoff" },
      ask: {
        kind: "task",
        text: { en: "Open the cone until it reaches A and B, but not C.", it: "Apri il cono finché raggiunge A e B, ma non C." },
        check: async (bench) => {
          const [a, b, c] = await Promise.all([bench.at(kNear), bench.at(kFar), bench.at(kOutside)]);
          if (!a?.light || !b?.light || !c?.light) {
            return kOutOfSight;
          }
          const isIn = [a, b, c].map((reading) => reading.light!.spot > 0);
          if (isIn[2]) {
            return { ok: false, say: { en: "C is lit, too.", it: "Anche C è illuminato." } };
          }
          return isIn[0] && isIn[1]
            ? { ok: true }
            : { ok: false, say: { en: "The cone is still too narrow.", it: "Il cono è ancora troppo stretto." } };
        },
        hint: {
          en: "The control is called Cone and is half of its angle. A lies 1.5 aside of a lamp that hangs 3 high.",
          it: "Il comando si chiama Cono ed è metà dell'apertura. A è a 1,5 di lato da una lampada alta 3.",
        },
        because: {
          en: "$\\arctan(1.5/3) \\approx 27°$ is where A and B come in, $\\arctan(2.25/3) \\approx 37°$ where C would.",
          it: "A $\\arctan(1{,}5/3) \\approx 27°$ entrano A e B, a $\\arctan(2{,}25/3) \\approx 37°$ entrerebbe C.",
        },
        solution: { kind: "change", changes: [["lights[0].cutoff", 32]] },
      },
    },
    {
      title: { en: "A soft rim", it: "Un bordo morbido" },
      text: {
        en: "The edge is as sharp as a knife, as OpenGL's was. Real lamps have a rim. Inside of a smaller cone, the beam, the spot is at its full; from there to the cutoff it fades.",
        it: "Il bordo è tagliente come un coltello, come quello di OpenGL. Le lampade vere hanno un orlo. Dentro un cono più stretto, il beam, il faretto è pieno; da lì al cutoff sfuma.",
      },
      formula: "\\sigma = t^2(3 - 2t)",
      scene: [["lights[0].cutoff", 32]],
      control: { tab: "lights", testid: "option-lights-beam" },
      ask: {
        kind: "task",
        text: { en: "Give the spot a soft rim.", it: "Dai al faretto un bordo morbido." },
        check: async (bench) => ({ ok: await hasSoftRim(bench, kBelow, kOutside) }),
        hint: { en: "Full inside: less than the cone's 32°. 18°, say.", it: "Pieno entro: meno dei 32° del cono. 18°, per esempio." },
        because: {
          en: "$t^2(3-2t)$ starts and ends level, so that no Mach band betrays where the fade begins. An exponent would fade the whole cone.",
          it: "$t^2(3-2t)$ parte e arriva in piano, così nessuna banda di Mach tradisce dove comincia la sfumatura. Un esponente sfumerebbe tutto il cono.",
        },
        solution: { kind: "change", changes: [["lights[0].beam", 18]] },
      },
    },
    {
      title: { en: "Question: a quarter of the light", it: "Domanda: un quarto della luce" },
      text: {
        en: "A bare lamp with power 2 hangs straight above A, 1.5 high. Read its share $f$ at A in Explain: it is $1/1.5^2$.",
        it: "Una lampada nuda con potenza 2 pende a piombo su A, alta 1,5. Leggi in Spiega la sua quota $f$ in A: è $1/1{,}5^2$.",
      },
      formula: "f = \\frac{1}{d^2}",
      scene: [["lights", [{ type: "point", name: "lamp", position: [0, 1.5, 0.8], attenuation: { falloff: 2 } }]]],
      marks: [{ letter: "A", at: kBelow }],
      control: { tab: "lights", testid: "option-lights-position" },
      ask: {
        kind: "task",
        text: {
          en: "Move the lamp straight up until A gets a quarter of the light that it gets now. Leave the power alone.",
          it: "Alza la lampada a piombo finché A riceve un quarto della luce che riceve ora. Non toccare la potenza.",
        },
        check: async (bench) => {
          const { lights } = await bench.picture();
          const [now, before] = await Promise.all([bench.at(kBelow), bench.before().at(kBelow)]);
          if (lights.length !== 1 || lights[0]!.type !== "point") {
            return { ok: false, say: kOneLamp };
          }
          if (!now?.light || !before?.light) {
            return kOutOfSight;
          }
          const { position } = lights[0]!;
          if (length(subtract([position[0], 0, position[2]], kBelow)) > 0.35) {
            return { ok: false, say: { en: "The lamp has left the place above A.", it: "La lampada non è più a piombo su A." } };
          }
          if (Math.abs(now.light.attenuation * now.light.distance ** 2 - 1) > 0.02) {
            return {
              ok: false,
              say:
                now.light.distance < 1
                  ? { en: "Nearer than 1, $f$ is held at 1. Upwards.", it: "Più vicino di 1, $f$ è limitata a 1. In su." }
                  : {
                      en: "The attenuation itself has changed: it shall be power 2.",
                      it: "È cambiata l'attenuazione stessa: dev'essere potenza 2.",
                    },
            };
          }
          const share = now.light.attenuation / before.light.attenuation;
          return {
            ok: Math.abs(share - 0.25) < 0.02,
            say: {
              en: `The lamp is ${shown(now.light.distance)} high, and A gets ${shown(share)} of what it got.`,
              it: `La lampada è alta ${shownItalian(now.light.distance)}, e A riceve ${shownItalian(share)} di prima.`,
            },
          };
        },
        hint: {
          en: "$f$ goes with $1/d^2$: which $d$ makes it four times smaller? Type the height into the lamp's position (its second number), or drag its handle.",
          it: "$f$ va come $1/d^2$: quale $d$ la rende quattro volte più piccola? Scrivi l'altezza nella posizione della lampada (il secondo numero), o trascina la maniglia.",
        },
        because: {
          en: "Twice as high, a quarter of the light; four times as high, a sixteenth. This one law decides where every lamp in every room hangs.",
          it: "Alta il doppio, un quarto della luce; il quadruplo, un sedicesimo. Questa sola legge decide dove si appende ogni lampada.",
        },
        solution: { kind: "change", changes: [["lights[0].position", [0, 3, 0.8]]] },
      },
    },
  ],
};
