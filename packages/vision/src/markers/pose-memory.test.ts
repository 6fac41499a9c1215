import { describe, expect, it } from 'vitest';
import { turned } from '../../test/marker-scene.ts';
import { createOpenCvRuntime } from '../../test/open-cv-set.ts';
import { assumedCalibration } from './camera-calibration.ts';
import { cameraMats, type MarkerPose, markerPoses } from './marker-pose.ts';
import { PoseMemory } from './pose-memory.ts';
import { angleBetween, rotate } from './rotations.ts';

const pose = (errorPx: number, tilt: number, x = 0): MarkerPose => ({
  position: { x, y: 0, z: -1 },
  orientation: turned(tilt, 0),
  errorPx,
});
const left = (errorPx: number) => pose(errorPx, 20);
const right = (errorPx: number) => pose(errorPx, -20);
const MS = 33;

describe('PoseMemory', () => {
  it('takes the lower error for a marker that was not seen before', () => {
    const memory = new PoseMemory();
    memory.begin(MS);
    expect(memory.choose('a', [right(0.1), left(0.11)], 0)).toEqual(right(0.1));
  });

  it('keeps the tilt before while the errors are near, and leaves it when they are not', () => {
    const memory = new PoseMemory();
    memory.begin(MS);
    memory.choose('a', [left(0.1), right(1.5)], 0);
    memory.begin(MS);
    expect(memory.choose('a', [right(0.1), left(0.15)], 0)).toEqual(left(0.15));
    memory.begin(MS);
    expect(memory.choose('a', [right(0.1), left(1.5)], 0)).toEqual(right(0.1));
  });

  it('remembers a marker that was missed once, and forgets it after half a second', () => {
    const memory = new PoseMemory();
    memory.begin(MS);
    memory.choose('a', [left(0.1)], 0);
    memory.begin(MS);
    memory.begin(MS);
    expect(memory.choose('a', [right(0.1), left(0.15)], 0)).toEqual(left(0.15));
    memory.begin(501);
    expect(memory.choose('a', [right(0.1), left(0.15)], 0)).toEqual(right(0.1));
  });

  it('does not mix two prints of one marker in a picture', () => {
    const memory = new PoseMemory();
    memory.begin(MS);
    expect(memory.choose('a', [pose(0.1, 0, -1)], 100)?.position.x).toBe(-1);
    expect(memory.choose('a', [pose(0.1, 0, 1)], 100)?.position.x).toBe(1);
    memory.begin(MS);
    expect(memory.choose('a', [pose(0.1, 0, -1)], 100)?.position.x).toBe(-1);
    expect(memory.choose('a', [pose(0.1, 0, 1)], 100)?.position.x).toBe(1);
  });
});

describe('markerPoses', () => {
  it('gives both tilts of a small marker, one of them the true one', async () => {
    const calibration = assumedCalibration(640, 480);
    const truth = turned(20, 10);
    const half = 0.02;
    const corners = [
      [-half, half],
      [half, half],
      [half, -half],
      [-half, -half],
    ].map(([x, y]) => {
      const turnedCorner = rotate(truth, { x: x!, y: y!, z: 0 });
      const depth = 1.5 - turnedCorner.z;
      return {
        x: calibration.cx + (calibration.fx * turnedCorner.x) / depth,
        y: calibration.cy - (calibration.fy * turnedCorner.y) / depth,
      };
    });
    const poses = await createOpenCvRuntime().run((cv, keep) =>
      markerPoses(cv, keep, corners, 2 * half, cameraMats(cv, keep, calibration)),
    );
    expect(poses).toHaveLength(2);
    const [best, other] = poses;
    expect(angleBetween(best!.orientation, truth)).toBeLessThan(0.01);
    expect(angleBetween(other!.orientation, truth)).toBeGreaterThan(0.3);
    expect(other!.errorPx).toBeLessThan(0.5);
    expect(best!.errorPx).toBeLessThan(other!.errorPx);
  });
});
