import { useEventListener } from '@vueuse/core';
import { onScopeDispose } from 'vue';
import type { Seat } from '../../sim/index.ts';
import { strike, whiteNoise } from '../../sound/audio/strike.ts';
import { pitchOf } from '../../sound/scale.ts';

/** For phones that cannot vibrate. @returns knocks once in the pitch of a player, after the first touch */
export function useHitKnock(): (seat: Seat) => void {
  let context: AudioContext | undefined;
  let noise: AudioBuffer | undefined;
  if (!('vibrate' in navigator) && 'AudioContext' in globalThis) {
    // Safari counts the end of a touch as a gesture, not its beginning
    for (const gesture of ['pointerdown', 'touchend'] as const)
      useEventListener(window, gesture, open, { capture: true, passive: true });
  }
  onScopeDispose(() => void context?.close().catch(() => undefined));

  function open(): void {
    context ??= new AudioContext();
    noise ??= whiteNoise(context);
    if (context.state !== 'running') context.resume().catch(() => undefined);
  }

  return (seat) => {
    if (context?.state !== 'running' || !noise) return;
    const note = { voice: 'knock', midi: pitchOf(seat), strength: 0.7 } as const;
    strike(context.destination, noise, note, context.currentTime);
  };
}
