import {
  TorusGeometry,
  ConeGeometry,
  LatheGeometry,
  SphereGeometry,
  Vector2,
  type BufferGeometry,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';

import { buildTurned } from './turned.ts';

/** The wooden foot of a piece: the token stands on it at this height, units. */
export const BASE_HEIGHT = 0.34;

export function buildFoot(): BufferGeometry {
  return buildTurned(
    [
      [0, 0],
      [0.86, 0],
      [0.86, 0.14],
      [0.7, 0.2],
      [0, 0.2],
    ],
    0.06,
    40,
  );
}

/** Between foot and token, in the player's colour. */
export function buildNeck(): BufferGeometry {
  return buildTurned(
    [
      [0, 0.18],
      [0.62, 0.18],
      [0.56, BASE_HEIGHT + 0.06],
      [0, BASE_HEIGHT + 0.06],
    ],
    0.04,
    32,
  );
}

/** Round the foot of seats whose shape is taken already. */
export function buildFootRing(): BufferGeometry {
  const ring = new TorusGeometry(0.93, 0.085, 10, 40);
  ring.rotateX(Math.PI / 2).translate(0, 0.1, 0);
  ring.deleteAttribute('uv');
  return ring;
}

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
