import { LatheGeometry, Vector2, type BufferGeometry } from 'three';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';
import { toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';

type Corner = readonly [radius: number, y: number];
const CORNER_PARTS = 4;
const CREASE = 0.5;

/** Wood from the lathe: a profile from bottom to top, with round corners. */
export function buildTurned(
  profile: readonly Corner[],
  corner: number,
  segments = 48,
): BufferGeometry {
  const points: Vector2[] = [];
  for (const [index, at] of profile.entries()) {
    const [before, after] = [profile[index - 1], profile[index + 1]];
    if (!before || !after) points.push(new Vector2(...at));
    else points.push(...rounded(before, at, after, corner));
  }
  const lathe = new LatheGeometry(points, segments);
  const flat = lathe.toNonIndexed();
  flat.deleteAttribute('normal');
  flat.computeVertexNormals();
  const creased = toCreasedNormals(flat, CREASE);
  lathe.dispose();
  flat.dispose();
  creased.deleteAttribute('uv');
  return creased;
}

function rounded(before: Corner, at: Corner, after: Corner, radius: number): Vector2[] {
  const middle = new Vector2(...at);
  const towards = (other: Corner): Vector2 => {
    const way = new Vector2(...other).sub(middle);
    return way.setLength(Math.min(radius, way.length() / 2)).add(middle);
  };
  const [from, to] = [towards(before), towards(after)];
  return Array.from({ length: CORNER_PARTS + 1 }, (_, index) => {
    const t = index / CORNER_PARTS;
    const [a, b, c] = [(1 - t) * (1 - t), 2 * t * (1 - t), t * t];
    return new Vector2(a * from.x + b * middle.x + c * to.x, a * from.y + b * middle.y + c * to.y);
  });
}

/** A cylinder that stands on y = 0. */
export function buildCylinder(radius: number, height: number, corner = 0.06): BufferGeometry {
  return buildTurned(
    [
      [0, 0],
      [radius, 0],
      [radius, height],
      [0, height],
    ],
    corner,
  );
}

/** A cone that stands on y = 0. */
export function buildCone(radius: number, height: number, corner = 0.08): BufferGeometry {
  return buildTurned(
    [
      [0, 0],
      [radius, 0],
      [0.02, height],
      [0, height],
    ],
    corner,
    40,
  );
}

/** A block that stands on y = 0. */
export function buildBlock(
  width: number,
  height: number,
  depth: number,
  corner = 0.08,
): BufferGeometry {
  const geometry = new RoundedBoxGeometry(width, height, depth, 3, corner);
  geometry.translate(0, height / 2, 0);
  geometry.deleteAttribute('uv');
  return geometry;
}
