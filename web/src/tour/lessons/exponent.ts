// Lesson 4: the exponent, and what normalised highlights are (docs/theory/lighting-equation.md; Lafortune and Willems 1994).
import type { Vec3 } from "../../engine/types";
import { highlightPeak, highlightShare, shown, shownItalian, type Bench } from "../bench";
import type { Lesson } from "../lesson";

const kStrength = 0.75;
const kQuestionMark: Vec3 = [0.45, 0.12, 0.8849];
const kLargestShare = 0.01;
/** A tenth is the border; who comes so near to it from below has found it. */
const kBelow = 0.1;
const kNearly = 0.075;

/** spec, without k_s: R.V to the power of n. */
async function lobeAt(bench: Bench): Promise<{ cosine: number; value: number; exponent: number } | undefined> {
  const reading = await bench.at(kQuestionMark);
  if (!reading?.light) {
    return undefined;
  }
  const exponent = reading.fragment.coefficients.shininess;
  const cosine = Math.max(0, reading.light.r_dot_v);
  return { cosine, exponent, value: cosine ** exponent };
}

export const exponent: Lesson = {
  id: "exponent",
  title: { en: "The exponent", it: "L'esponente" },
  about: { en: "One number from satin to mirror", it: "Un numero, dal satinato allo specchio" },
  scene: {
    image: { background: [0.06, 0.07, 0.09] },
    camera: { view: "front" },
    shading: { lighting: "phong", interpolation: "phong" },
    ambient: [0.12, 0.12, 0.12],
    lights: [{ type: "directional", direction: [-0.48, -0.6, -0.64] }],
    objects: [
      {
        name: "ball",
        mesh: "primitive:sphere:96",
        material: { ambient: [0.06, 0.2, 0.4], diffuse: [0.06, 0.2, 0.4], specular: [kStrength, kStrength, kStrength], shininess: 5 },
      },
    ],
  },
  steps: [
    {
      title: { en: "Tight and wide", it: "Stretto e largo" },
      text: {
        en: "$\\mathbf R\\cdot\\mathbf V$ is 1 in the middle of the highlight and falls to the sides. A power pushes everything below 1 towards 0: the larger $n$, the faster. Phong chose a power because it is cheap, not because physics asked for one.",
        it: "$\\mathbf R\\cdot\\mathbf V$ vale 1 al centro del riflesso e cala ai lati. Una potenza spinge verso 0 tutto ciò che è sotto 1: più grande è $n$, più in fretta. Phong scelse una potenza perché costa poco, non perché la fisica la chieda.",
      },
      formula: "\\operatorname{spec} = \\max(\\mathbf R\\cdot\\mathbf V,\\, 0)^n",
      control: { tab: "material", testid: "option-materials-x-shininess" },
      ask: {
        kind: "task",
        text: {
          en: "Raise the exponent until the highlight, counted where it has more than half of its strength, covers less than 1 % of the ball.",
          it: "Alza l'esponente finché il riflesso, contato dove ha più di metà della forza, copre meno dell'1 % della palla.",
        },
        check: async (bench) => {
          if ((await highlightPeak(bench)) < kStrength / 2) {
            return {
              ok: false,
              say: {
                en: "Keep the highlight: lower neither $k_s$ nor the lamp.",
                it: "Il riflesso deve restare: non abbassare né $k_s$ né la lampada.",
              },
            };
          }
          const share = await highlightShare(bench, kStrength);
          return {
            ok: share < kLargestShare,
            say: {
              en: `It covers ${shown(100 * share, 1)} % of the ball.`,
              it: `Quota della palla che copre: ${shownItalian(100 * share, 1)} %.`,
            },
          };
        },
        hint: {
          en: "The exponent $n$ is on the Material tab. The area falls as $1/n$.",
          it: "L'esponente $n$ è nella scheda Materiale. L'area cala come $1/n$.",
        },
        because: {
          en: "The area goes with $1/n$: ten times the exponent, a tenth of the highlight. The eye reads it as polish.",
          it: "L'area va come $1/n$: dieci volte l'esponente, un decimo del riflesso. L'occhio lo legge come lucidatura.",
        },
        solution: { kind: "change", changes: [["objects[0].material.shininess", 80]] },
      },
    },
    {
      title: { en: "Smaller, but brighter?", it: "Più piccolo, ma più chiaro?" },
      text: {
        en: "Left $n = 8$, right $n = 120$; nothing else differs. The right one is the better mirror.",
        it: "A sinistra $n = 8$, a destra $n = 120$; per il resto sono uguali. Quella di destra è lo specchio migliore.",
      },
      scene: [["objects[0].material.shininess", 8]],
      comparison: { kind: "settings", left: [], right: [["objects[0].material.shininess", 120]] },
      isSideBySide: true,
      ask: {
        kind: "choice",
        text: { en: "How do the two highlights compare in their very middle?", it: "Nel loro centro esatto, come sono i due riflessi?" },
        options: [
          {
            text: { en: "The tight one is brighter", it: "Quello stretto è più chiaro" },
            reply: {
              en: "A real mirror would do that. But what is $1^{120}$?",
              it: "Uno specchio vero farebbe così. Ma quanto fa $1^{120}$?",
            },
          },
          {
            text: { en: "The wide one is brighter", it: "Quello largo è più chiaro" },
            reply: {
              en: "It looks brighter since there is more of it. Compare the middles: what is $1^{8}$?",
              it: "Sembra più chiaro perché è più esteso. Confronta i centri: quanto fa $1^{8}$?",
            },
          },
          { text: { en: "They are equally bright", it: "Sono ugualmente chiari" }, reply: { en: "", it: "" } },
        ],
        answer: async (bench) => {
          const wide = await highlightPeak(bench.with([["objects[0].material.shininess", 8]]));
          const tight = await highlightPeak(bench.with([["objects[0].material.shininess", 120]]));
          return tight > 1.05 * wide ? 0 : wide > 1.05 * tight ? 1 : 2;
        },
        because: {
          en: "$1^n = 1$: the peak is $k_s$ for every $n$. So the tighter highlight sends out less light altogether, which no polishing does to a real surface.",
          it: "$1^n = 1$: il massimo è $k_s$ per ogni $n$. Così il riflesso più stretto rimanda in tutto meno luce, cosa che nessuna lucidatura fa a una superficie vera.",
        },
      },
    },
    {
      title: { en: "Keeping the energy", it: "Conservare l'energia" },
      text: {
        en: "Real plastic mirrors only some 4 % of the light that falls on it straight. With $k_s = 0.04$ the classic highlight has all but vanished, though on real plastic it dazzles. **Normalised** lobes are scaled so that they send back the share $k_s$ of the light, whatever $n$ is.",
        it: "La plastica vera riflette solo circa il 4 % della luce che la colpisce in pieno. Con $k_s = 0{,}04$ il riflesso classico è quasi sparito, eppure sulla plastica vera abbaglia. I lobi **normalizzati** sono scalati in modo da rimandare la quota $k_s$ della luce, qualunque sia $n$.",
      },
      formula: "k_s\\, \\frac{n+2}{2}\\, (\\mathbf R\\cdot\\mathbf V)^n\\, (\\mathbf N\\cdot\\mathbf L)",
      scene: [
        ["objects[0].material.shininess", 60],
        ["objects[0].material.specular", [0.04, 0.04, 0.04]],
      ],
      control: { tab: "shading", testid: "option-shading-normalized" },
      ask: {
        kind: "task",
        text: { en: "Switch to normalised highlights.", it: "Passa ai riflessi normalizzati." },
        check: async (bench) => {
          const [before, now] = [await highlightPeak(bench.before()), await highlightPeak(bench)];
          const times = now / Math.max(1e-6, before);
          return {
            ok: bench.scene.shading?.["normalized"] === true && times > 5,
            ...(times > 1.5
              ? { say: { en: `The peak is ${shown(times, 0)} times as high.`, it: `Il massimo è ${shown(times, 0)} volte più alto.` } }
              : {}),
          };
        },
        hint: {
          en: "Normalised lobes: a switch on the Shading tab.",
          it: "Lobi normalizzati: un interruttore nella scheda Ombreggiatura.",
        },
        because: {
          en: "The same 4 %, gathered in a small spot. Now a tighter highlight is a brighter one, and $k_s$ can be measured.",
          it: "Lo stesso 4 %, raccolto in una piccola macchia. Ora un riflesso più stretto è più chiaro, e $k_s$ si può misurare.",
        },
        solution: { kind: "change", changes: [["shading.normalized", true]] },
      },
    },
    {
      title: { en: "To the power of nothing", it: "Elevato a niente" },
      text: {
        en: "What is a highlight with $n = 0$? By the rules $x^0 = 1$ for every $x$: it is $k_s$ wherever light arrives.",
        it: "Che cos'è un riflesso con $n = 0$? Per le regole $x^0 = 1$ per ogni $x$: vale $k_s$ ovunque arrivi luce.",
      },
      formula: "x^0 = 1",
      scene: [
        ["shading.normalized", undefined],
        ["objects[0].material.specular", [kStrength, kStrength, kStrength]],
        ["objects[0].material.shininess", 60],
      ],
      control: { tab: "material", testid: "option-materials-x-shininess" },
      ask: {
        kind: "task",
        text: {
          en: "Set the exponent to 0, and look at the edge of the shadow.",
          it: "Metti l'esponente a 0 e guarda il bordo dell'ombra.",
        },
        check: async (bench) => {
          const reading = await bench.at([0, 0, 1]);
          return { ok: reading?.fragment.coefficients.shininess === 0 && (await highlightPeak(bench)) > 0.3 };
        },
        hint: { en: "Type 0 into the exponent's field.", it: "Scrivi 0 nel campo dell'esponente." },
        because: {
          en: "The light ends in a hard edge: a highlight needs $\\mathbf N\\cdot\\mathbf L > 0$, and that gate is a step, not a fade. With a low $n$ you can always see it.",
          it: "La luce finisce con un bordo netto: un riflesso vuole $\\mathbf N\\cdot\\mathbf L > 0$, e quella soglia è uno scalino, non una sfumatura. Con $n$ basso si vede sempre.",
        },
        solution: { kind: "change", changes: [["objects[0].material.shininess", 0]] },
      },
    },
    {
      title: { en: "Question: down to a tenth", it: "Domanda: fino a un decimo" },
      text: {
        en: "A stands beside the highlight: read its $\\mathbf R\\cdot\\mathbf V$ in Explain. With $n = 4$ much of the highlight still reaches it.",
        it: "A sta accanto al riflesso: leggi il suo $\\mathbf R\\cdot\\mathbf V$ in Spiega. Con $n = 4$ gran parte del riflesso ci arriva ancora.",
      },
      formula: "(\\mathbf R\\cdot\\mathbf V)^n < 0.1",
      scene: [["objects[0].material.shininess", 4]],
      marks: [{ letter: "A", at: kQuestionMark }],
      control: { tab: "material", testid: "option-materials-x-shininess" },
      ask: {
        kind: "task",
        text: {
          en: "Find the exponent with which $(\\mathbf R\\cdot\\mathbf V)^n$ at A has just fallen below 0.1 (0.075 to 0.1 counts).",
          it: "Trova l'esponente con cui $(\\mathbf R\\cdot\\mathbf V)^n$ in A è appena sceso sotto 0,1 (vale da 0,075 a 0,1).",
        },
        check: async (bench) => {
          const lobe = await lobeAt(bench);
          if (!lobe) {
            return { ok: false, say: { en: "A is out of sight: frame the ball again.", it: "A non si vede: inquadra di nuovo la palla." } };
          }
          const { cosine, value, exponent: n } = lobe;
          const en = `${shown(cosine, 3)} to the power of ${shown(n, 0)} is ${shown(value, 3)}.`;
          const it = `${shownItalian(cosine, 3)} elevato a ${shown(n, 0)} fa ${shownItalian(value, 3)}.`;
          return { ok: value < kBelow && value >= kNearly, say: { en, it } };
        },
        hint: {
          en: "Take the logarithm of both sides: $n > \\ln 0.1 / \\ln(\\mathbf R\\cdot\\mathbf V)$. Or try: double $n$ until it is too much.",
          it: "Prendi il logaritmo dei due lati: $n > \\ln 0{,}1 / \\ln(\\mathbf R\\cdot\\mathbf V)$. Oppure prova: raddoppia $n$ finché è troppo.",
        },
        because: {
          en: "$n = \\ln 0.1 / \\ln(\\mathbf R\\cdot\\mathbf V)$: with it you can choose an exponent for the width that you want, instead of guessing.",
          it: "$n = \\ln 0{,}1 / \\ln(\\mathbf R\\cdot\\mathbf V)$: così puoi scegliere l'esponente per la larghezza che vuoi, invece di tirare a indovinare.",
        },
        solution: {
          kind: "change",
          changes: async (bench) => {
            const { cosine } = (await lobeAt(bench))!;
            return [["objects[0].material.shininess", Math.ceil(Math.log(kBelow) / Math.log(cosine) + 1e-6)]];
          },
        },
      },
    },
  ],
};
