/** Values of a pad: 0 to 1 with y down, as on a screen; or up to a bound around 0, with y up. */
export type PadArea = 'surface' | { readonly bound: number };

interface Point {
  readonly x: number;
  readonly y: number;
}

const within01 = (share: number): number => Math.min(1, Math.max(0, share));
/** To three decimals, without a negative zero. */
const rounded = (value: number): number => Number(value.toFixed(3)) || 0;

/** Returns the place of a value, both axes 0 to 1, origin top left; values outside are at the edge. */
export function placeOnPad({ x, y }: Point, area: PadArea): Point {
  if (area === 'surface') return { x: within01(x), y: within01(y) };
  const { bound } = area;
  return { x: within01((x / bound + 1) / 2), y: within01((1 - y / bound) / 2) };
}

/** Returns the value at a place, which may be outside the pad. */
export function valueOnPad(place: Point, area: PadArea): { x: number; y: number } {
  const [across, down] = [within01(place.x), within01(place.y)];
  if (area === 'surface') return { x: rounded(across), y: rounded(down) };
  return {
    x: rounded((across * 2 - 1) * area.bound),
    y: rounded((1 - down * 2) * area.bound),
  };
}
