import {
  useLocalStorage,
  useDocumentVisibility,
  useEventListener,
  useIntervalFn,
} from '@vueuse/core';
import { onScopeDispose, watch, type Ref } from 'vue';

import type { RoundState } from '../modules/index.ts';
import type { RoomView } from '../net/index.ts';
import { GAMES, type Game, type GameId, type Hud } from '../sim/index.ts';
import {
  countEvents,
  hudEvents,
  moodOf,
  roomEvents,
  SoundEngine,
  stateEvents,
  tuneOf,
} from '../sound/index.ts';
import type { ScreenLink } from './screen-link.ts';

/** Sound settings of this screen: stored in the browser, shared by all callers in a page. */
export function useSoundSettings() {
  return {
    isMuted: useLocalStorage('ubii.party.muted', false),
    isMusicMuted: useLocalStorage('ubii.party.music-muted', false),
  };
}

/** Steps between two looks at the words of a round and at the music. */
const STEPS_BETWEEN_LOOKS = 6;

/** Plays the music and sounds of a party, from the first gesture on. */
export function useSound(
  link: ScreenLink,
  { isMuted, isMusicMuted }: { isMuted: Ref<boolean>; isMusicMuted: Ref<boolean> },
): void {
  const engine = new SoundEngine();
  const visibility = useDocumentVisibility();
  let view: RoomView | undefined = link.view;
  let round: { readonly newest: RoundState; readonly hud?: Hud } | undefined;
  let mood = '';
  let left: number | undefined;

  watch(
    [isMuted, isMusicMuted, visibility],
    () => {
      engine.apply({
        isMuted: isMuted.value,
        isMusicMuted: isMusicMuted.value,
        isHidden: visibility.value === 'hidden',
      });
      // Switching the sound on is a gesture, as is the click that led to this page
      if (!isMuted.value && navigator.userActivation?.hasBeenActive) engine.start();
    },
    { immediate: true },
  );
  for (const gesture of ['pointerdown', 'keydown'] as const)
    useEventListener(window, gesture, () => engine.start(), { capture: true, passive: true });

  const ends = [
    link.onView((next) => {
      engine.play(roomEvents(view, next));
      view = next;
      followMood();
    }),
    link.onState((game, state) => playEvents(game, state)),
    () => engine.close(),
  ];
  onScopeDispose(() => ends.forEach((end) => end()));
  useIntervalFn(() => {
    const { phase, endsAtMs = 0 } = view?.room ?? {};
    const now = phase === 'countdown' ? Math.ceil((endsAtMs - link.nowMs()) / 1000) : undefined;
    engine.play(countEvents(left, now));
    left = now;
  }, 50);
  followMood();

  function playEvents(game: GameId, newest: RoundState): void {
    const before = round?.newest.id === newest.id ? round : undefined;
    const events = before ? stateEvents(game, before.newest.state, newest.state) : [];
    let hud = before?.hud;
    const isTime = !before || lookOf(newest) !== lookOf(before.newest);
    if (!hud || isTime) {
      const next = (GAMES[game] as Game<unknown>).hud(newest.state, String);
      events.push(...hudEvents(hud, next));
      hud = next;
    }
    round = { newest, hud };
    engine.play(events);
    if (isTime) followMood();
  }

  function lookOf({ step }: RoundState): number {
    return Math.floor(step / STEPS_BETWEEN_LOOKS);
  }

  function followMood(): void {
    const isOfThisRound = round !== undefined && round.newest.id === view?.round?.id;
    const next = view && moodOf(view.room, isOfThisRound ? round!.newest.state : undefined);
    const text = JSON.stringify(next) ?? '';
    if (text === mood) return;
    mood = text;
    engine.setTune(next && tuneOf(next));
  }
}
