const STEP = 0.01;
const LARGE_STEP = 0.1;

const DIRECTIONS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/**
 * Returns the position after an arrow key; both axes 0 to 1, origin top left.
 * @returns `undefined` for other keys
 */
export function stepPosition(
  from: { readonly x: number; readonly y: number },
  key: string,
  large: boolean,
): { x: number; y: number } | undefined {
  const direction = DIRECTIONS[key];
  if (!direction) return undefined;
  const step = large ? LARGE_STEP : STEP;
  const move = (value: number, sign: number) => Math.min(1, Math.max(0, value + sign * step));
  return { x: move(from.x, direction[0]), y: move(from.y, direction[1]) };
}
