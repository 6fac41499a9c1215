import { useEventListener } from '@vueuse/core';
import { inject, shallowRef, type InjectionKey, type ShallowRef } from 'vue';
import { steeringOfTilt, tiltOf } from './steering-inputs.ts';

/**
 * `ask`: the browser wants a tap first (iOS). `silent`: nothing came yet, such as on a laptop or over plain HTTP.
 */
export type TiltAccess = 'ask' | 'silent' | 'refused' | 'arrives';

/** iOS has this on the constructor, and no declaration knows it. */
interface Asks {
  readonly requestPermission?: () => Promise<PermissionState>;
}

export interface Tilt {
  readonly access: Readonly<ShallowRef<TiltAccess>>;
  /** To be called at once in the handler of a tap. Does nothing where no permission is needed. */
  ask(): Promise<void>;
  /** Straight ahead is how the phone is held now. */
  recentre(): void;
  /** -1 to 1; undefined while no sensor speaks. */
  steering(): number | undefined;
}

export const TILT: InjectionKey<Tilt> = Symbol('tilt');

/** The tilt sensor, for as long as the calling scope lives. */
export function createTilt(): Tilt {
  const asks = (window as { DeviceOrientationEvent?: Asks }).DeviceOrientationEvent;
  // Chromium has the question as well, and answers it by itself.
  const isAsked = asks?.requestPermission !== undefined && !('userAgentData' in navigator);
  const access = shallowRef<TiltAccess>(isAsked ? 'ask' : 'silent');
  let tilt: number | undefined;
  let neutral = 0;

  useEventListener(window, 'deviceorientation', ({ beta, gamma }) => {
    // Browsers of computers send one event without any values.
    if (beta === null || gamma === null) return;
    access.value = 'arrives';
    tilt = tiltOf(beta, gamma, screen.orientation?.angle ?? 0);
  });

  return {
    access,
    async ask() {
      if (access.value !== 'ask' && access.value !== 'refused') return;
      try {
        const answer = await asks?.requestPermission?.();
        access.value = answer === 'granted' ? 'silent' : 'refused';
      } catch {
        // There was no tap: the next one may ask again.
        access.value = 'ask';
      }
    },
    recentre: () => void (neutral = tilt ?? 0),
    steering: () => (tilt === undefined ? undefined : steeringOfTilt(tilt, neutral)),
  };
}

export function useTilt(): Tilt {
  const tilt = inject(TILT);
  if (!tilt) throw new Error('Screens of the phone live inside PartyPhone.');
  return tilt;
}
