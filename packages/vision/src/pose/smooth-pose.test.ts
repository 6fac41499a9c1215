import { describe, expect, it } from 'vitest';
import type { BodyPose } from './body-pose.ts';
import { PoseSmoother } from './smooth-pose.ts';

const poseAt = (x: number, score = 0.9): BodyPose => ({
  score,
  keypoints: [{ name: 'nose', x, y: 0.5, score }],
});
const xOf = (pose: BodyPose) => pose.keypoints[0]!.x;

describe('PoseSmoother', () => {
  it('goes 63 % of the way in its time constant, in one step or in many', () => {
    const coarse = new PoseSmoother({ timeConstantMs: 100 });
    coarse.smooth(poseAt(0), 0);
    expect(xOf(coarse.smooth(poseAt(1), 100))).toBeCloseTo(1 - 1 / Math.E);
    const fine = new PoseSmoother({ timeConstantMs: 100 });
    fine.smooth(poseAt(0), 0);
    const last = Array.from({ length: 10 }, () => fine.smooth(poseAt(1), 10)).at(-1)!;
    expect(xOf(last)).toBeCloseTo(1 - 1 / Math.E);
  });

  it('starts where a keypoint is first seen, and where it is seen again', () => {
    const smoother = new PoseSmoother();
    expect(xOf(smoother.smooth(poseAt(0.7), 16))).toBe(0.7);
    expect(xOf(smoother.smooth(poseAt(0.1, 0.05), 16))).toBe(0.1);
    expect(xOf(smoother.smooth(poseAt(0.8), 16))).toBe(0.8);
  });

  it('does nothing with a time constant of 0', () => {
    const smoother = new PoseSmoother({ timeConstantMs: 0 });
    smoother.smooth(poseAt(0), 0);
    expect(xOf(smoother.smooth(poseAt(1), 0))).toBe(1);
  });

  it('stays when no time has passed', () => {
    const smoother = new PoseSmoother();
    smoother.smooth(poseAt(0.2), 0);
    expect(xOf(smoother.smooth(poseAt(1), -5))).toBe(0.2);
  });
});
