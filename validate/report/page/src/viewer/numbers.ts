// Formats numbers.

/** The shortest decimal that reads back as the same 32-bit float. */
export function shortestFloat(value: number): string {
  for (let digits = 1; digits <= 9; ++digits) {
    const text = value.toPrecision(digits);
    if (Math.fround(Number(text)) === value) return String(Number(text));
  }
  return String(value); // NaN, infinity
}

/** With the given number of significant digits, without trailing zeros. */
export function significant(value: number, digits: number): string {
  return String(Number(value.toPrecision(digits)));
}

/** An integer with thin spaces between thousands. */
export function wholeNumber(value: number): string {
  return String(value).replace(/\B(?=(\d{3})+$)/g, "\u202f");
}

/** Rounded up to two significant digits; 0 stays 0. */
export function roundedUp(value: number): number {
  if (!(value > 0)) return 0;
  const unit = 10 ** (Math.floor(Math.log10(value)) - 1);
  // 1e-9: a quotient that is an integer up to rounding isn't increased.
  return Number((Math.ceil(value / unit - 1e-9) * unit).toPrecision(2));
}
