import { AT_REST, type Controls, type Seat } from '../game.ts';
import { length, unit } from '../plane/vector.ts';
import { standing, type HillState, type Piece } from './hill-state.ts';

/** Seeks the middle, and dashes at who stands between it and the edge. */
export function hillBot(state: HillState, seat: Seat): Controls {
  const own = state.pieces.find((piece) => piece.seat === seat);
  if (!own || own.outAt !== undefined) return AT_REST;
  const target = victim(state, own);
  const atEdge = length(own.position) > state.radius * 0.7;
  const goal = atEdge || !target ? { x: 0, y: 0 } : target.position;
  // Predicted position: on ice one steers against one's own speed
  const ahead = {
    x: goal.x - own.position.x - own.velocity.x * 0.5,
    y: goal.y - own.position.y - own.velocity.y * 0.5,
  };
  const { x, y } = unit(ahead, { x: 0, y: 0 });
  const isNear = target !== undefined && distance(own, target) < 4;
  return { x, y, isPressed: !atEdge && isNear && own.charge < 0.7 };
}

/** The nearest piece among those further out. */
function victim(state: HillState, own: Piece): Piece | undefined {
  return standing(state)
    .filter((piece) => piece !== own && length(piece.position) >= length(own.position))
    .sort((a, b) => distance(own, a) - distance(own, b) || a.seat - b.seat)[0];
}

function distance(a: Piece, b: Piece): number {
  return length({ x: a.position.x - b.position.x, y: a.position.y - b.position.y });
}
