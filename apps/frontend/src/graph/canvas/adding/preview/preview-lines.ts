import { linePath } from '../../../../ui/charts/line-path.ts';

/** Time that a preview shows, milliseconds. */
export const PREVIEW_MS = 5000;

/** Numbers of a value at a time. */
export interface NumbersAt {
  /** Epoch milliseconds. */
  readonly atMs: number;
  readonly numbers: readonly number[];
}

/** Lines of a chart as SVG paths; empty without two values. */
export interface PreviewLines {
  readonly input: string;
  readonly output: string;
}

/** Part of the chart's span without values at which a line has a gap. */
const GAP = 0.2;

/**
 * Draws one number of input and output over the same time: that which varies most at the input. Values of the same kind
 * have the same scale.
 *
 * @param fromMs left edge, epoch milliseconds
 * @param isAlike the output has the data format of the input
 */
export function previewLines(
  input: readonly NumbersAt[],
  output: readonly NumbersAt[],
  { fromMs, toMs, width, height }: Readonly<Record<'fromMs' | 'toMs' | 'width' | 'height', number>>,
  isAlike: boolean,
): PreviewLines {
  const ofInput = columnOf(input, mostVarying(input));
  const ofOutput = columnOf(output, mostVarying(isAlike ? input : output));
  const both = [...ofInput, ...ofOutput];
  const draw = (points: readonly NumberAt[], scaledBy: readonly NumberAt[]): string => {
    const [low, high] = boundsOf(scaledBy);
    const path = points.map(({ atMs, number }) => ({
      x: ((atMs - fromMs) / (toMs - fromMs)) * width,
      y: high === low ? height / 2 : height - ((number - low) / (high - low)) * height,
    }));
    return linePath(
      path.flatMap((point, i) => {
        const before = path[i - 1];
        const isGap = before !== undefined && point.x - before.x > GAP * width;
        return isGap ? [{ x: before.x, y: undefined }, point] : [point];
      }),
    );
  };
  return {
    input: draw(ofInput, isAlike ? both : ofInput),
    output: draw(ofOutput, isAlike ? both : ofOutput),
  };
}

interface NumberAt {
  readonly atMs: number;
  readonly number: number;
}

const columnOf = (all: readonly NumbersAt[], index: number): NumberAt[] =>
  all.flatMap(({ atMs, numbers }) => {
    const number = numbers[index];
    return number !== undefined && Number.isFinite(number) ? [{ atMs, number }] : [];
  });

/** Index of the number with the largest span. */
function mostVarying(all: readonly NumbersAt[]): number {
  const width = Math.max(0, ...all.map(({ numbers }) => numbers.length));
  let most = { index: 0, span: -1 };
  for (let index = 0; index < width; index++) {
    const [low, high] = boundsOf(columnOf(all, index));
    if (high - low > most.span) most = { index, span: high - low };
  }
  return most.index;
}

function boundsOf(points: readonly NumberAt[]): [low: number, high: number] {
  let [low, high] = [Infinity, -Infinity];
  for (const { number } of points) {
    low = Math.min(low, number);
    high = Math.max(high, number);
  }
  return [low, high];
}
