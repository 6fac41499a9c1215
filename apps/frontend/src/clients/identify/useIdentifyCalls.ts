import { identifyTopic } from '@ubii/proto';
import { computed, shallowRef, type ShallowRef } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { readCall, type IdentifyCall } from './identify-calls.ts';

const SEEN_KEY = 'ubii.identifySeen';
const BUZZ_MS = [180, 120, 180];
/** Time within which further requests are merged, milliseconds: limits flashing. */
const REST_MS = 3000;

/** Current request; set `undefined` to dismiss it. `count` is incremented with each flash. */
export function useIdentifyCalls(): {
  call: ShallowRef<IdentifyCall | undefined>;
  count: Readonly<ShallowRef<number>>;
} {
  const { client, isConnected } = useConnection();
  const call = shallowRef<IdentifyCall>();
  const count = shallowRef(0);
  const seen = {
    load: () => sessionStorage.getItem(SEEN_KEY),
    save: (text: string) => sessionStorage.setItem(SEEN_KEY, text),
  };
  let flashedMs = -Infinity;

  function show(next: IdentifyCall): void {
    call.value = next;
    const nowMs = performance.now();
    if (nowMs - flashedMs < REST_MS) return;
    flashedMs = nowMs;
    count.value += 1;
    // Without a user interaction, browsers refuse and log a warning.
    if (navigator.userActivation?.hasBeenActive) navigator.vibrate?.(BUZZ_MS);
  }

  // The id is known after connecting, and an original master may assign another one.
  const topic = computed<string | undefined>((before) =>
    isConnected.value ? identifyTopic(client.id) : before,
  );
  useTopic(topic, {
    format: 'string',
    keep: 0,
    whileHidden: true,
    onRecord(record) {
      const next = readCall(record, seen);
      if (next) show(next);
    },
  });

  return { call, count };
}
