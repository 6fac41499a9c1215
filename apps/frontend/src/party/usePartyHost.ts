import { systemClock } from '@ubii/client-web';
import { PartyHost, type PartyHostListener } from '@ubii/party/net';
import type { ScreenLink } from '@ubii/party/screen';
import { RoomRefusal } from '@ubii/party/sim';
import { onBeforeUnmount, ref, shallowRef } from 'vue';
import { useConnection } from '../connection/useConnection.ts';
import { hostStorage } from './host-memory.ts';

/** Hosts the party while the page is open. */
export function usePartyHost() {
  const { client } = useConnection();
  const trouble = ref('');
  /** True when another screen is the host. */
  const isSuperseded = ref(false);
  const views = new Set<NonNullable<PartyHostListener['handleView']>>();
  const states = new Set<NonNullable<PartyHostListener['handleState']>>();

  const cheers = new Set<NonNullable<PartyHostListener['handleCheer']>>();
  const photos = new Set<NonNullable<PartyHostListener['handlePhotos']>>();

  const open = (): PartyHost =>
    new PartyHost({
      client,
      clock: systemClock,
      storage: hostStorage,
      drawByte: () => crypto.getRandomValues(new Uint8Array(1))[0]!,
      listener: {
        handleView: (view) => views.forEach((fn) => fn(view)),
        handleState: (game, state) => states.forEach((fn) => fn(game, state)),
        handleCheer: (cheer) => cheers.forEach((fn) => fn(cheer)),
        handlePhotos: (now) => photos.forEach((fn) => fn(now)),
        handleSuperseded: () => (isSuperseded.value = true),
        handleTrouble: (sentence) => (trouble.value = sentence),
      },
    });
  const host = shallowRef(open());

  async function start(): Promise<void> {
    try {
      await client.connect();
      await host.value.start();
    } catch (cause) {
      trouble.value = cause instanceof Error ? cause.message : String(cause);
    }
  }
  void start();
  onBeforeUnmount(() => host.value.close());

  const link: ScreenLink = {
    get view() {
      return host.value.view;
    },
    nowMs: () => client.masterTime.nowMs(),
    onView(fn) {
      views.add(fn);
      return () => views.delete(fn);
    },
    onState(fn) {
      states.add(fn);
      return () => states.delete(fn);
    },
    onCheer(fn) {
      cheers.add(fn);
      return () => cheers.delete(fn);
    },
    get droppedCheers() {
      return host.value.droppedCheers;
    },
    apply(event) {
      try {
        host.value.apply(event);
        return undefined;
      } catch (cause) {
        if (cause instanceof RoomRefusal) return cause.message;
        throw cause;
      }
    },
    offerSeat: (seat) => host.value.offerSeat(seat),
    setSetting: (game, setting, value) => host.value.setSetting(game, setting, value),
    onPhotos(fn) {
      photos.add(fn);
      return () => photos.delete(fn);
    },
    takeDownPhoto: (seat) => host.value.takeDownPhoto(seat),
    hidePhotos: (areHidden) => host.value.hidePhotos(areHidden),
  };

  return {
    link,
    trouble,
    isSuperseded,
    /** Becomes the host again. */
    takeBack(): void {
      isSuperseded.value = false;
      host.value = open();
      void start();
    },
    end: (): Promise<void> => host.value.end(),
  };
}
