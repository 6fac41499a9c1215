/** Width of a strip in the units of its drawing; it is stretched to the width of its place. */
export const barWidth = 4;
const FILLED = 2.6;

/** Draws bars around the middle line as one path. Their height grows with the root, so that little can be seen. */
export function stripPath(activity: ArrayLike<number>, height: number): string {
  const amounts = Array.from(activity);
  const most = Math.max(1e-9, ...amounts);
  return amounts
    .map((amount, index) => {
      if (amount <= 0) return '';
      const tall = Math.max(1.5, Math.sqrt(amount / most) * height);
      const top = (height - tall) / 2;
      return `M${index * barWidth} ${round(top)}h${FILLED}v${round(tall)}h-${FILLED}z`;
    })
    .join('');
}

const round = (value: number): number => Math.round(value * 100) / 100;
