import { ConeGeometry, LatheGeometry, SphereGeometry, Vector2, type BufferGeometry } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';

const POINTS = 5;
const RADIUS = 0.46;

/** Of the leader; there is one. Stands on y = 0. */
export function buildCrown(): { readonly gold: BufferGeometry; readonly pearls: BufferGeometry } {
  const bowl = new LatheGeometry(
    [
      [0, 0.02],
      [0.36, 0],
      [0.42, 0.05],
      [0.5, 0.3],
      [0.52, 0.36],
      [0.47, 0.38],
      [0, 0.34],
    ].map(([x, y]) => new Vector2(x, y)),
    32,
  );
  const around = Array.from({ length: POINTS }, (_, index) => (index / POINTS) * Math.PI * 2 + 0.3);
  const spikes = around.map((angle) =>
    new ConeGeometry(0.17, 0.46, 14)
      .translate(0, 0.56, 0)
      .translate(Math.sin(angle) * RADIUS * 0.82, 0, Math.cos(angle) * RADIUS * 0.82),
  );
  const pearls = around.map((angle) =>
    new SphereGeometry(0.09, 14, 10).translate(
      Math.sin(angle) * RADIUS * 0.82,
      0.82,
      Math.cos(angle) * RADIUS * 0.82,
    ),
  );
  return { gold: merged([bowl, ...spikes]), pearls: merged(pearls) };
}

export function merged(parts: readonly BufferGeometry[]): BufferGeometry {
  const plain = parts.map((part) => (part.index ? part.toNonIndexed() : part));
  for (const part of plain) part.deleteAttribute('uv');
  const whole = mergeGeometries(plain);
  for (const part of [...parts, ...plain]) part.dispose();
  return whole;
}
