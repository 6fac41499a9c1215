import { computed, inject, onScopeDispose, shallowRef, triggerRef, type ComputedRef } from 'vue';
import type { InjectionKey, ShallowRef } from 'vue';
import type { Player, Room, Spectator } from '../../sim/index.ts';
import type { PhoneAction, RoundView } from '../../net/index.ts';
import type { PhoneFacts, PhoneLink } from '../../net/phone/phone-link.ts';

/** Dependencies of every screen of the phone. */
export interface PhoneContext {
  readonly link: PhoneLink;
  readonly facts: Readonly<ShallowRef<PhoneFacts>>;
  readonly me: ComputedRef<Player | undefined>;
  readonly spectator: ComputedRef<Spectator | undefined>;
  readonly room: ComputedRef<Room | undefined>;
  readonly round: ComputedRef<RoundView | undefined>;
  /** The leader's phone leads the game. */
  readonly isLeader: ComputedRef<boolean>;
  /** @throws Error whose message is a sentence for the player */
  ask(action: PhoneAction): Promise<{ readonly code?: string }>;
}

export const PHONE: InjectionKey<PhoneContext> = Symbol('phone');

export function createPhoneContext(link: PhoneLink): PhoneContext {
  const facts = shallowRef(link.facts);
  onScopeDispose(
    link.onChange(() => {
      facts.value = link.facts;
      // A link may keep one object and change what is in it.
      triggerRef(facts);
    }),
  );
  const me = computed(() => facts.value.me);
  const room = computed(() => facts.value.view?.room);
  return {
    link,
    facts,
    me,
    spectator: computed(() => facts.value.spectator),
    room,
    round: computed(() => facts.value.view?.round),
    isLeader: computed(() => me.value !== undefined && room.value?.leader === me.value.seat),
    ask: (action) => link.ask(action),
  };
}

export function usePhone(): PhoneContext {
  const phone = inject(PHONE);
  if (!phone) throw new Error('Screens of the phone live inside PartyPhone.');
  return phone;
}

/** Asks the host for one thing at a time, and keeps its refusal for the screen. */
export function useAsking() {
  const { ask } = usePhone();
  const isAsking = shallowRef(false);
  const refusal = shallowRef<string>();
  return {
    isAsking,
    /** One sentence; undefined after the next request that is granted. */
    refusal,
    async request(action: PhoneAction): Promise<{ readonly code?: string } | undefined> {
      if (isAsking.value) return undefined;
      isAsking.value = true;
      try {
        const reply = await ask(action);
        refusal.value = undefined;
        return reply;
      } catch (error) {
        refusal.value = (error as Error).message;
        return undefined;
      } finally {
        isAsking.value = false;
      }
    },
  };
}
