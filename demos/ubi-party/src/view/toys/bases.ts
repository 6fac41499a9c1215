import { TorusGeometry, type BufferGeometry } from 'three';
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
