import { Box3, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { identityOf, MAX_SEATS } from '../../sim/index.ts';
import { outlineOf, buildConfetti, buildToken, TOKEN_DEPTH } from './token-geometry.ts';

const SHAPES = [...new Set(Array.from({ length: MAX_SEATS }, (_, seat) => identityOf(seat).shape))];

describe.each(SHAPES)('token %s', (shape) => {
  const geometry = buildToken(shape);
  const size = new Box3().setFromBufferAttribute(geometry.getAttribute('position') as never);

  it('stands on the ground, as large as the others', () => {
    expect(size.min.y).toBeCloseTo(0, 1);
    expect(size.max.y).toBeGreaterThan(1.8);
    expect(size.max.y).toBeLessThan(2.6);
    expect(size.max.x - size.min.x).toBeGreaterThan(1.8);
    expect(size.max.x - size.min.x).toBeLessThan(2.7);
    expect(size.max.z - size.min.z).toBeCloseTo(TOKEN_DEPTH, 3);
  });

  it('has its letter on its face', () => {
    const { letter, shape: outline, inset } = outlineOf(shape);
    const corners = (inset ?? outline).getPoints(24);
    const isInside = (x: number, y: number): boolean =>
      corners.reduce((inside, a, index) => {
        const b = corners[(index + 1) % corners.length]!;
        const crosses = a.y > y !== b.y > y && x < ((b.x - a.x) * (y - a.y)) / (b.y - a.y) + a.x;
        return crosses ? !inside : inside;
      }, false);
    // A capital fills about half of its field
    const half = letter.size * 0.25;
    for (const [x, y] of [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ] as const) {
      expect(isInside(letter.x + x * half, letter.y + y * half)).toBe(true);
    }
  });

  it('has finite corners, and normals of length 1', () => {
    const normals = geometry.getAttribute('normal');
    const normal = new Vector3();
    for (let index = 0; index < normals.count; index += 1) {
      normal.fromBufferAttribute(normals, index);
      expect(Math.abs(normal.length() - 1)).toBeLessThan(1e-3);
    }
  });

  it('has a thin piece of confetti', () => {
    const confetti = buildConfetti(shape);
    confetti.computeBoundingBox();
    expect(confetti.boundingBox!.max.z - confetti.boundingBox!.min.z).toBeLessThan(0.12);
  });
});
