import { shallowRef, type ShallowRef } from 'vue';
import type { Sphere } from './framing.ts';
import { orbitKey, pan, startOrbit, turn, zoom, type Orbit, type Up } from './orbit.ts';
import { ORIGIN } from './space-things.ts';

/** Rotation for a drag across the whole picture, radians. */
const TURN_ACROSS = Math.PI * 1.5;
const WHEEL_ZOOM = 0.0015;

/** Rotates, pans and zooms by mouse, touch, wheel and keys. */
export interface OrbitGesture {
  readonly orbit: Readonly<ShallowRef<Orbit>>;
  /** True after the user changed the view, until it is reset. */
  readonly isChosen: Readonly<ShallowRef<boolean>>;
  reset(shown: Sphere): void;
  press(event: PointerEvent): void;
  move(event: PointerEvent): void;
  release(event: PointerEvent): void;
  wheel(event: WheelEvent): void;
  /** @returns true for a key that was handled */
  key(event: KeyboardEvent): boolean;
}

interface Held {
  x: number;
  y: number;
  /** Pans instead of rotating. */
  readonly isPan: boolean;
}

export function createOrbitGesture(up: () => Up): OrbitGesture {
  const orbit = shallowRef(startOrbit({ center: ORIGIN, radius: 1 }));
  const isChosen = shallowRef(false);
  const held = new Map<number, Held>();

  function set(next: Orbit): void {
    orbit.value = next;
    isChosen.value = true;
  }
  /** Centre and distance of the first two fingers, pixels. */
  function pinch(): { x: number; y: number; apart: number } {
    const [a, b] = [...held.values()] as [Held, Held];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y) };
  }

  return {
    orbit,
    isChosen,
    reset(shown) {
      orbit.value = startOrbit(shown);
      isChosen.value = false;
    },
    press(event) {
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
      const isPan = event.button !== 0 || event.shiftKey;
      held.set(event.pointerId, { x: event.clientX, y: event.clientY, isPan });
    },
    move(event) {
      const one = held.get(event.pointerId);
      if (!one) return;
      const { height, width } = (event.currentTarget as Element).getBoundingClientRect();
      const size = Math.max(1, Math.min(height, width));
      const before = held.size > 1 ? pinch() : undefined;
      const [dx, dy] = [event.clientX - one.x, event.clientY - one.y];
      one.x = event.clientX;
      one.y = event.clientY;
      if (before) {
        const now = pinch();
        const moved = pan(
          orbit.value,
          (before.x - now.x) / height,
          (now.y - before.y) / height,
          up(),
        );
        set(zoom(moved, before.apart / Math.max(1, now.apart)));
      } else if (one.isPan) set(pan(orbit.value, -dx / height, dy / height, up()));
      else set(turn(orbit.value, (-dx / size) * TURN_ACROSS, (dy / size) * TURN_ACROSS));
    },
    release(event) {
      held.delete(event.pointerId);
    },
    wheel(event) {
      set(zoom(orbit.value, Math.exp(Math.max(-200, Math.min(200, event.deltaY)) * WHEEL_ZOOM)));
    },
    key(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return false;
      const next = orbitKey(orbit.value, event.key, event.shiftKey, up());
      if (next) set(next);
      return next !== undefined;
    },
  };
}
