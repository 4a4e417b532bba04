// Numbers for readers: significant digits, no trailing zeros, powers of ten where a number is very small or large. As text and as TeX.

function parts(value: number, digits: number): { mantissa: string; exponent?: number } {
  if (value === 0 || !Number.isFinite(value)) {
    return { mantissa: value === 0 ? "0" : Number.isNaN(value) ? "?" : value > 0 ? "∞" : "-∞" };
  }
  const rounded = Number(value.toPrecision(digits));
  const size = Math.abs(rounded);
  if (size >= 1e-3 && size < 1e6) {
    return { mantissa: String(rounded) };
  }
  const [mantissa, exponent] = rounded.toExponential().split("e") as [string, string];
  return { mantissa, exponent: Number(exponent) };
}

const kRaised = "⁰¹²³⁴⁵⁶⁷⁸⁹";

function raised(exponent: number): string {
  const digits = [...String(Math.abs(exponent))].map((digit) => kRaised[Number(digit)]).join("");
  return exponent < 0 ? `⁻${digits}` : digits;
}

/** `0.7388`, `1.2×10⁻⁵`; with a real minus sign. */
export function numberText(value: number, digits = 4): string {
  const { mantissa, exponent } = parts(value, digits);
  return `${mantissa.replace("-", "−")}${exponent === undefined ? "" : `×10${raised(exponent)}`}`;
}

/** The same for KaTeX. */
export function numberTex(value: number, digits = 4): string {
  const { mantissa, exponent } = parts(value, digits);
  const shown = mantissa.replace("∞", "\\infty");
  return exponent === undefined ? shown : `${shown}{\\times}10^{${exponent}}`;
}

/** As a factor of a product: negative ones stand in parentheses. */
export function factorTex(value: number, digits = 4): string {
  return value < 0 ? `(${numberTex(value, digits)})` : numberTex(value, digits);
}

export function vectorText(value: readonly number[], digits = 4): string {
  return value.map((number) => numberText(number, digits)).join("  ");
}

/** `75 %`, `0.4 %` */
export function percentText(share: number): string {
  return `${numberText(share * 100, 3)} %`;
}
