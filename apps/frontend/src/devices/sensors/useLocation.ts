import type { Vector4 } from '@ubii/proto';
import { onScopeDispose, shallowRef } from 'vue';

export type LocationState = 'off' | 'insecure' | 'missing' | 'asking' | 'refused' | 'on';

/**
 * Location of the device, after the user has requested it.
 *
 * @param handle called with x: latitude and y: longitude in degrees (WGS 84), z: altitude in metres (0 when
 *   unknown), w: radius of uncertainty in metres
 */
export function useLocation(handle: (place: Vector4) => void) {
  const state = shallowRef<LocationState>(firstState());
  let watchId: number | undefined;

  function start(): void {
    if (watchId !== undefined || state.value === 'insecure' || state.value === 'missing') return;
    state.value = 'asking';
    watchId = navigator.geolocation.watchPosition(
      ({ coords }) => {
        state.value = 'on';
        const { latitude, longitude, altitude, accuracy } = coords;
        handle({ x: latitude, y: longitude, z: altitude ?? 0, w: accuracy });
      },
      (error) => {
        // A position may be found later; a refusal is final.
        if (error.code !== error.PERMISSION_DENIED) return;
        stop();
        state.value = 'refused';
      },
      { enableHighAccuracy: true },
    );
  }

  function stop(): void {
    if (watchId !== undefined) navigator.geolocation.clearWatch(watchId);
    watchId = undefined;
    state.value = firstState();
  }
  onScopeDispose(stop);
  return { state, start, stop };
}

function firstState(): LocationState {
  if (!isSecureContext) return 'insecure';
  return 'geolocation' in navigator ? 'off' : 'missing';
}
