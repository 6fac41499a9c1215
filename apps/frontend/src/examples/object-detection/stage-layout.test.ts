import { describe, expect, it } from 'vitest';
import { placeStages, spreadLabels, stageTicks } from './stage-layout.ts';

describe('the strip of stages', () => {
  it('is to scale, and shows the shortest stage', () => {
    const placed = placeStages([10, 0, 30], 402, 2);
    expect(placed.map(({ x }) => Math.round(x))).toEqual([0, 100, 102]);
    expect(placed[2]!.width / placed[0]!.width).toBeCloseTo(3, 0);
    const last = placed.at(-1)!;
    expect(last.x + last.width + 2).toBeCloseTo(402);
  });

  it('has a scale of round steps, eight at most', () => {
    expect(stageTicks(62)).toEqual([0, 10, 20, 30, 40, 50, 60]);
    expect(stageTicks(8)).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8]);
    expect(stageTicks(1300)).toEqual([0, 200, 400, 600, 800, 1000, 1200]);
    expect(stageTicks(0)).toEqual([]);
  });

  it('moves labels apart, back in from the end, and leaves out the least one where there is no room', () => {
    const label = (x: number, weight = 1) => ({ x, width: 40, weight });
    expect(spreadLabels([label(0), label(10), label(190)], 200, 5)).toEqual([0, 45, 160]);
    expect(spreadLabels([label(150), label(155)], 200, 5)).toEqual([115, 160]);
    expect(spreadLabels([label(0, 3), label(10, 1), label(60, 2)], 100, 5)).toEqual([
      0,
      undefined,
      60,
    ]);
  });
});
