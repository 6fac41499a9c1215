import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { CameraRig, type Framing } from './camera-rig.ts';

const FRAMING: Framing = {
  pitchDeg: 30,
  points: [
    { x: -12, y: 0, z: 4 },
    { x: 12, y: 0, z: 4 },
    { x: 0, y: 5, z: -8 },
  ],
  rect: { left: 0.35, right: 0.95, top: 0.1, bottom: 0.8 },
  tallRect: { left: 0.05, right: 0.95, top: 0.5, bottom: 0.78 },
};

describe('camera rig', () => {
  it.each([
    ['a wide picture', 1440 / 900, FRAMING.rect],
    ['a high picture', 390 / 844, FRAMING.tallRect],
  ])('leaves the words their part of %s', (_, aspect, rect) => {
    const rig = new CameraRig();
    rig.resize(aspect);
    rig.frame(FRAMING, true);
    rig.update(0, 1, 0);
    for (const { x, y, z } of FRAMING.points) {
      const at = new Vector3(x, y, z).project(rig.camera);
      const [right, down] = [(at.x + 1) / 2, (1 - at.y) / 2];
      expect(right).toBeGreaterThan(rect.left - 1e-6);
      expect(right).toBeLessThan(rect.right + 1e-6);
      expect(down).toBeGreaterThan(rect.top - 1e-6);
      expect(down).toBeLessThan(rect.bottom + 1e-6);
    }
  });

  it('looks down further to fill a higher picture, as far as the scene allows', () => {
    const wide = { left: 0, right: 1, top: 0, bottom: 1 };
    const heightOf = (framing: Framing, aspect: number): number => {
      const rig = new CameraRig();
      rig.resize(aspect);
      rig.frame(framing, true);
      rig.update(0, 1, 0);
      const ys = framing.points.map(
        ({ x, y, z }) => new Vector3(x, y, z).project(rig.camera).y / 2,
      );
      return Math.max(...ys) - Math.min(...ys);
    };
    const flat = { ...FRAMING, rect: wide };
    const steep = { ...flat, mostPitchDeg: 50 };
    expect(heightOf(steep, 1.6)).toBeGreaterThan(heightOf(flat, 1.6) * 1.15);
    expect(heightOf(steep, 1.6)).toBeLessThanOrEqual(1);
  });
});
