// Lesson 7: vertex normals, creases, and when smooth shading is wrong (docs/theory/vertex-normals.md; Thürmer and Wüthrich 1998).
import type { SceneObject, Vec3 } from "../../engine/types";
import { angleBetween, faceNormal, shown, type Bench } from "../bench";
import type { Lesson } from "../lesson";
import { dot } from "../../stage/vector";

const kRed = { ambient: [0.5, 0.1, 0.1], diffuse: [0.5, 0.1, 0.1], specular: [0.5, 0.5, 0.5], shininess: 30 };
const kBlue = { ambient: [0.08, 0.2, 0.4], diffuse: [0.08, 0.2, 0.4], specular: [0.5, 0.5, 0.5], shininess: 30 };
const kCube: SceneObject = { name: "cube", mesh: "primitive:cube", material: kRed };
const kBall = (segments: number): SceneObject => ({ name: "ball", mesh: `primitive:sphere:${segments}`, material: kBlue });

const kCubeAside: SceneObject = { ...kCube, matrix: [0.8, 0, 0, -1.2, 0, 0.8, 0, 0, 0, 0, 0.8, 0, 0, 0, 0, 1] };
const kBallAside: SceneObject = { ...kBall(12), matrix: [1, 0, 0, 1.2, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] };

/** Away from the middle of the cube's front face, where an averaged normal leans. */
const kOnCube: Vec3 = [0.6, 0.5, 1];
const kOnCubeAside: Vec3 = [-0.72, 0.4, 0.8];

/** Degrees between the normal that is shaded with and the triangle's own. */
async function lean(bench: Bench, place: Vec3): Promise<number | undefined> {
  const reading = await bench.at(place);
  return reading && angleBetween(reading.shading.normal, faceNormal(reading));
}

/** The ball alone looks as if all of its faces shared their normals. */
async function isBallSmooth(bench: Bench, ball: SceneObject): Promise<boolean> {
  const alone = bench.with([["objects", [ball]]]);
  return (await alone.picture()).hash === (await alone.with([["shading.crease", 180]]).picture()).hash;
}

/** The least whole number of degrees from which on a ball is smooth all over. */
async function leastCrease(bench: Bench, ball: SceneObject): Promise<number> {
  let [sharp, smooth] = [0, 180];
  while (smooth - sharp > 1) {
    const middle = (sharp + smooth) >> 1;
    if (await isBallSmooth(bench.with([["shading.crease", middle]]), ball)) {
      smooth = middle;
    } else {
      sharp = middle;
    }
  }
  return smooth;
}

/** A place that is lit though its triangle faces away from the light: the first on a grid over the picture. */
async function liarPlace(bench: Bench): Promise<Vec3> {
  for (let y = 10; y < 180; y += 5) {
    for (let x = 10; x < 240; x += 5) {
      const reading = await bench.readPixel(x, y);
      if (reading?.light && reading.light.n_dot_l > 0.08 && dot(faceNormal(reading), reading.light.to_light) < -0.02) {
        return reading.fragment.position;
      }
    }
  }
  throw new Error("no place is lit from behind its face");
}

export const edges: Lesson = {
  id: "edges",
  title: { en: "Real edges", it: "Spigoli veri" },
  about: {
    en: "Creases, normals of vertices, and when smooth is wrong",
    it: "Pieghe, normali dei vertici, e quando il liscio è sbagliato",
  },
  scene: {
    image: { background: [0.06, 0.07, 0.09] },
    camera: { view: "three-quarter" },
    shading: { lighting: "phong", interpolation: "phong", recompute_normals: true, crease: 180 },
    ambient: [0.12, 0.12, 0.12],
    lights: [{ type: "directional", direction: [-0.4, -0.5, -1] }],
    objects: [kCube],
  },
  steps: [
    {
      title: { en: "The pillow", it: "Il cuscino" },
      text: {
        en: "Each corner of this cube has one normal: the average of the three faces that meet there. Phong shading believes it, and bends the light as if the cube were blown up. The outline says cube, the shading says pillow.",
        it: "Ogni angolo di questo cubo ha una sola normale: la media delle tre facce che vi s'incontrano. L'ombreggiatura di Phong le crede, e piega la luce come se il cubo fosse gonfio. Il contorno dice cubo, la luce dice cuscino.",
      },
      formula: "\\mathbf n = \\frac{\\sum_f w_f\\, \\mathbf n_f}{\\left|\\sum_f w_f\\, \\mathbf n_f\\right|}",
      control: { tab: "explain", testid: "tab-explain" },
      ask: {
        kind: "task",
        text: {
          en: "Click a place where the shaded normal leans by more than 30° from the face.",
          it: "Fai clic dove la normale usata s'inclina di oltre 30° rispetto alla faccia.",
        },
        check: async (bench) => {
          const reading = await bench.picked();
          if (!reading) {
            return { ok: false, say: { en: "Click a place on the cube.", it: "Fai clic su un punto del cubo." } };
          }
          const angle = angleBetween(reading.shading.normal, faceNormal(reading));
          return { ok: angle > 30, say: { en: `Here they are ${shown(angle, 0)}° apart.`, it: `Qui distano ${shown(angle, 0)}°.` } };
        },
        hint: {
          en: "In the middle of a face the corners balance. Go towards a corner.",
          it: "Al centro di una faccia gli angoli si bilanciano. Vai verso un angolo.",
        },
        because: {
          en: "At the corner itself it is 54.7°, the angle between a cube's diagonal and its faces' normals. So far can a normal lie.",
          it: "Nell'angolo stesso sono 54,7°, l'angolo tra la diagonale di un cubo e le normali delle facce. Fin lì può mentire una normale.",
        },
        solution: { kind: "pick", at: async () => [0.85, 0.8, 1] },
      },
    },
    {
      title: { en: "Who votes?", it: "Chi vota?" },
      text: {
        en: "Renderers draw triangles, so each square of the cube is cut in two. At some corners a square is there with both of its triangles, at others with one. If triangles voted, squares with two would win.",
        it: "I renderer disegnano triangoli, perciò ogni quadrato del cubo è tagliato in due. In certi angoli un quadrato c'è con entrambi i triangoli, in altri con uno solo. Se votassero i triangoli, vincerebbero i quadrati che ne hanno due.",
      },
      control: { tab: "shading", testid: "option-shading-vertex_normals" },
      ask: {
        kind: "choice",
        text: {
          en: "Normals at vertices: try uniform, area and angle. How does the picture of the cube change?",
          it: "Normali ai vertici: prova uniforme, area e angolo. Come cambia l'immagine del cubo?",
        },
        options: [
          { text: { en: "Not at all", it: "Per niente" }, reply: { en: "", it: "" } },
          {
            text: { en: "With uniform weights the corners lean", it: "Con i pesi uniformi gli angoli s'inclinano" },
            reply: {
              en: "They would if triangles voted. Switch, and look closely.",
              it: "Lo farebbero se votassero i triangoli. Cambia, e guarda bene.",
            },
          },
          {
            text: { en: "All three look different", it: "Tutti e tre sono diversi" },
            reply: { en: "Switch to and fro, and look closely.", it: "Passa dall'uno all'altro, e guarda bene." },
          },
        ],
        answer: async (bench) => {
          const hashes = new Set<string | undefined>();
          for (const weights of ["uniform", "area", "angle"]) {
            hashes.add((await bench.with([["shading.vertex_normals", weights]]).picture()).hash);
          }
          return hashes.size - 1;
        },
        because: {
          en: "Here whole polygons vote, however they are cut, and a cube's three squares have the same area and the same angle at the corner. On meshes that come as triangles, weights by angle do the same: they do not change when a face is cut in two.",
          it: "Qui votano i poligoni interi, comunque siano tagliati, e i tre quadrati di un cubo hanno nell'angolo la stessa area e lo stesso angolo. Sulle mesh già a triangoli ci pensano i pesi per angolo: non cambiano se una faccia è tagliata in due.",
        },
      },
    },
    {
      title: { en: "The crease", it: "La piega" },
      text: {
        en: "Real edges shall stay sharp. Faces share a normal only where they turn by at most the **crease** angle; elsewhere the vertex is doubled, one normal a side. The cube's faces turn by 90°.",
        it: "Gli spigoli veri devono restare netti. Le facce condividono la normale solo dove girano al massimo dell'angolo di **piega**; altrove il vertice si sdoppia, una normale per lato. Le facce del cubo girano di 90°.",
      },
      marks: [{ letter: "A", at: kOnCube }],
      control: { tab: "shading", testid: "option-shading-crease" },
      ask: {
        kind: "task",
        text: { en: "Lower the crease angle until the cube is a cube.", it: "Abbassa l'angolo di piega finché il cubo è un cubo." },
        check: async (bench) => {
          if ((await bench.at(kOnCube))?.explanation.interpolation === "flat") {
            return {
              ok: false,
              say: {
                en: "Flat shading hides the question: stay with Phong.",
                it: "L'ombreggiatura piatta nasconde il problema: resta con Phong.",
              },
            };
          }
          const angle = await lean(bench, kOnCube);
          return angle === undefined
            ? { ok: false, say: { en: "A is out of sight.", it: "A non si vede." } }
            : {
                ok: angle < 1,
                say: { en: `At A the normal leans by ${shown(angle, 0)}°.`, it: `In A la normale s'inclina di ${shown(angle, 0)}°.` },
              };
        },
        hint: { en: "Below 90° the faces of a cube part.", it: "Sotto i 90° le facce di un cubo si separano." },
        because: {
          en: "Eight corners, three normals each. Exactly at 90° they would still share: the angle itself counts as smooth.",
          it: "Otto angoli, tre normali ciascuno. A 90° esatti sarebbero ancora condivise: l'angolo stesso conta come liscio.",
        },
        solution: { kind: "change", changes: [["shading.crease", 60]] },
      },
    },
    {
      title: { en: "Smooth here, sharp there", it: "Liscio qui, netto là" },
      text: {
        en: "A scan or an STL file has no names for its edges: one angle has to tell bends from creases. The ball has 12 segments, so its faces turn by up to about 30°. Now the crease is too small for it.",
        it: "Una scansione o un file STL non danno nomi agli spigoli: un solo angolo deve distinguere curve e pieghe. La palla ha 12 segmenti, e le sue facce girano fino a circa 30°. Ora la piega è troppo piccola per lei.",
      },
      scene: [
        ["shading.crease", 15],
        ["objects", [kCubeAside, kBallAside]],
      ],
      control: { tab: "shading", testid: "option-shading-crease" },
      ask: {
        kind: "task",
        text: {
          en: "Find a crease angle with which the ball is smooth and the cube sharp.",
          it: "Trova un angolo di piega con cui la palla è liscia e il cubo netto.",
        },
        check: async (bench) => {
          if (bench.scene.shading?.["interpolation"] === "flat") {
            return {
              ok: false,
              say: {
                en: "Flat shading makes everything sharp: stay with Phong.",
                it: "L'ombreggiatura piatta rende tutto netto: resta con Phong.",
              },
            };
          }
          const isSmooth = await isBallSmooth(bench, kBallAside);
          const isSharp = ((await lean(bench.with([["camera", { view: "three-quarter" }]]), kOnCubeAside)) ?? 90) < 1;
          if (!isSmooth) {
            return { ok: false, say: { en: "The ball still has hard edges.", it: "La palla ha ancora spigoli netti." } };
          }
          return isSharp
            ? { ok: true }
            : {
                ok: false,
                say: {
                  en: "The ball is smooth, but the cube is a pillow again.",
                  it: "La palla è liscia, ma il cubo è di nuovo un cuscino.",
                },
              };
        },
        hint: { en: "More than the ball's 30°, less than the cube's 90°.", it: "Più dei 30° della palla, meno dei 90° del cubo." },
        because: {
          en: "Anything between 31° and 89° does. Lustro takes 40° for STL files, and leaves other meshes smooth.",
          it: "Va bene tutto tra 31° e 89°. Per i file STL Lustro usa 40°, e lascia lisce le altre mesh.",
        },
        solution: { kind: "change", changes: [["shading.crease", 40]] },
      },
    },
    {
      title: { en: "A polite lie", it: "Una bugia gentile" },
      text: {
        en: "Smooth normals are a fiction, and near the terminator it shows: the interpolated normal still sees the light while the triangle has already turned its back on it. The equation believes the normal.",
        it: "Le normali lisce sono una finzione, e vicino al terminatore si vede: la normale interpolata guarda ancora la luce mentre il triangolo le ha già voltato le spalle. L'equazione crede alla normale.",
      },
      scene: [
        ["shading.crease", 180],
        ["camera", { view: "front" }],
        ["lights", [{ type: "directional", direction: [-1, -0.1, -0.3] }]],
        ["objects", [kBall(8)]],
      ],
      control: { tab: "explain", testid: "tab-explain" },
      ask: {
        kind: "task",
        text: {
          en: "Click a place that is lit though its triangle faces away from the light.",
          it: "Fai clic su un punto illuminato benché il suo triangolo volti le spalle alla luce.",
        },
        check: async (bench) => {
          const reading = await bench.picked();
          if (!reading?.light) {
            return { ok: false, say: { en: "Click a place on the ball.", it: "Fai clic su un punto della palla." } };
          }
          const normal = angleBetween(reading.shading.normal, reading.light.to_light);
          const face = angleBetween(faceNormal(reading), reading.light.to_light);
          return {
            ok: normal < 90 && face > 90,
            say: {
              en: `The normal is ${shown(normal, 0)}° from the light, the triangle's own ${shown(face, 0)}°.`,
              it: `La normale è a ${shown(normal, 0)}° dalla luce, quella del triangolo a ${shown(face, 0)}°.`,
            },
          };
        },
        hint: {
          en: "Look beside the terminator, on the dark side of an edge.",
          it: "Cerca accanto al terminatore, dal lato scuro di uno spigolo.",
        },
        because: {
          en: "Add shadows, and such triangles shadow themselves: the jagged terminator on coarse models. More triangles are the honest cure.",
          it: "Con le ombre, triangoli simili si fanno ombra da soli: è il terminatore a scalini dei modelli grossolani. La cura onesta sono più triangoli.",
        },
        solution: { kind: "pick", at: liarPlace },
      },
    },
    {
      title: { en: "Question: the least crease", it: "Domanda: la piega minima" },
      text: {
        en: "A ball of 16 segments around, 8 from pole to pole. A crease of 0° makes every face an island.",
        it: "Una palla di 16 segmenti in giro, 8 da polo a polo. Una piega di 0° fa di ogni faccia un'isola.",
      },
      scene: [
        ["shading.crease", 0],
        ["camera", { view: "three-quarter" }],
        ["lights", [{ type: "directional", direction: [-0.4, -0.5, -1] }]],
        ["objects", [kBall(16)]],
      ],
      control: { tab: "shading", testid: "option-shading-crease" },
      ask: {
        kind: "number",
        text: {
          en: "From how many degrees of crease on is it smooth all over? Try it, in whole degrees.",
          it: "Da quanti gradi di piega in poi è tutta liscia? Prova, in gradi interi.",
        },
        unit: "°",
        answer: (bench) => leastCrease(bench, kBall(16)),
        tolerance: { absolute: 0.6 },
        slips: [
          {
            fits: (given, answer) => given < answer - 0.6 && given > answer - 8,
            say: {
              en: "Near. With that, some edges are still sharp: look at all of the ball.",
              it: "Ci sei quasi. Così alcuni spigoli sono ancora netti: guarda tutta la palla.",
            },
          },
          {
            fits: (given, answer) => given > answer + 0.6 && given < 180,
            say: { en: "It is smooth with that, but already with less.", it: "Così è liscia, ma lo è già con meno." },
          },
        ],
        hint: {
          en: "16 segments share 360°. Start there, and raise the crease until the last edge is gone.",
          it: "16 segmenti si dividono 360°. Parti da lì, e alza la piega finché sparisce l'ultimo spigolo.",
        },
        because: {
          en: "360°/16 is 22.5°, and the comparison is exact: 22° leaves edges, 23° does not. A crease angle is a statement about how finely the mesh was made.",
          it: "360°/16 fa 22,5°, e il confronto è esatto: 22° lascia spigoli, 23° no. Un angolo di piega dice quanto finemente è stata fatta la mesh.",
        },
      },
    },
  ],
};
