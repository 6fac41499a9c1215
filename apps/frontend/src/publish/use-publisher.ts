import type { JsonObject } from '@ubii/proto';
import { onScopeDispose, ref, shallowRef, type Ref, type ShallowRef } from 'vue';
import { useConnection } from '../connection/useConnection.ts';
import { checkRecord, readRecord, topicOfJson } from './record-json.ts';
import { variableSource } from './variables.ts';

/** How often a record can be repeated, records per second. */
export const RATE_HZ = { least: 0.1, most: 100 } as const;

/** Sends records from this page, once or again and again. */
export interface Publisher {
  /** Records that were sent since the page was opened. */
  readonly sent: Readonly<Ref<number>>;
  /** Why the last one was not sent, one sentence. */
  readonly error: Readonly<ShallowRef<string | undefined>>;
  readonly isRepeating: Readonly<Ref<boolean>>;
  send(): boolean;
  /** Sends another record than the page's own. */
  sendRecord(record: JsonObject): boolean;
  /** Sends now and at a rate until `stop`, which also leaving the page does. */
  repeat(rateHz: number): void;
  stop(): void;
  check(json: JsonObject): ReturnType<typeof checkRecord>;
}

export function usePublisher(json: () => JsonObject): Publisher {
  const { client, isConnected } = useConnection();
  const sent = ref(0);
  const error = shallowRef<string>();
  const isRepeating = ref(false);
  const source = variableSource(() => sent.value);
  let timer: ReturnType<typeof setInterval> | undefined;

  onScopeDispose(
    client.onError((problem) => {
      error.value = problem.message;
    }),
  );

  const send = (): boolean => sendRecord(json());

  function sendRecord(record: JsonObject): boolean {
    if (!isConnected.value) {
      error.value = 'Nothing was sent: this page is not connected to the master.';
      return false;
    }
    const [problem] = checkRecord(record, source);
    if (problem) {
      error.value = `Nothing was sent: ${problem.path || 'it'} ${problem.sentence}`;
      return false;
    }
    try {
      const { topic, format, value } = readRecord(record, source);
      client.publish(topic, format, value);
      sent.value++;
      error.value = undefined;
      return true;
    } catch (cause) {
      const reason = cause instanceof Error ? cause.message : String(cause);
      error.value = `Nothing was sent on ${topicOfJson(record)}: ${reason}`;
      return false;
    }
  }
  function stop(): void {
    clearInterval(timer);
    isRepeating.value = false;
  }
  onScopeDispose(stop);

  return {
    sent,
    error,
    isRepeating,
    send,
    sendRecord,
    stop,
    check: (record) => checkRecord(record, source),
    repeat(rateHz) {
      stop();
      const hz = Math.min(RATE_HZ.most, Math.max(RATE_HZ.least, rateHz));
      isRepeating.value = true;
      send();
      timer = setInterval(send, 1000 / hz);
    },
  };
}
