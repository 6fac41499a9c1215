import { identifyTopic } from '@ubii/proto';
import { computed, shallowRef, type ShallowRef } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { readCall, type IdentifyCall } from './identify-calls.ts';

const SEEN_KEY = 'ubii.identifySeen';
const BUZZ_MS = [180, 120, 180];
/** Calls that follow each other faster are one: a page must not flash all the time. */
const REST_MS = 3000;

/** The call this page shows now; assign `undefined` to dismiss it. `count` goes up with each flash. */
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
    // Without a touch before, browsers refuse, and complain about it
    if (navigator.userActivation?.hasBeenActive) navigator.vibrate?.(BUZZ_MS);
  }

  // The id comes with the connection, and an original master may give another one.
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
