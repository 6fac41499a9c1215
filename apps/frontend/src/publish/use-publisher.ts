import type { JsonObject } from '@ubii/proto';
import { onScopeDispose, ref, shallowRef, type Ref, type ShallowRef } from 'vue';
import { useConnection } from '../connection/useConnection.ts';
import { checkRecord, readRecord, topicOfJson } from './record-json.ts';
import { variableSource } from './variables.ts';

/** Limits of the repeat rate, records per second. */
export const RATE_HZ = { least: 0.1, most: 100 } as const;
/** How long values published here stay after this tab was closed, minutes. Longer than a reload or a break. */
export const KEPT_MINUTES = 60;

/** Publishes records from this page, once or repeatedly. */
export interface Publisher {
  /** Records published since the page was opened. */
  readonly sent: Readonly<Ref<number>>;
  /** Topic of the last record; empty before the first. */
  readonly sentTo: Readonly<Ref<string>>;
  /** Why the last record was not published, one sentence. */
  readonly error: Readonly<ShallowRef<string | undefined>>;
  readonly isRepeating: Readonly<Ref<boolean>>;
  send(): boolean;
  /** Publishes this record instead of the one on the page. */
  sendRecord(record: JsonObject): boolean;
  /** Publishes now and then at this rate, until `stop` or until the page is left. */
  repeat(rateHz: number): void;
  stop(): void;
  check(json: JsonObject): ReturnType<typeof checkRecord>;
}

export function usePublisher(json: () => JsonObject): Publisher {
  const { client, isConnected } = useConnection();
  const sent = ref(0);
  const sentTo = ref('');
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
      error.value = 'Not published: this page has no connection to the master.';
      return false;
    }
    const [problem] = checkRecord(record, source);
    if (problem) {
      error.value = `Not published: ${problem.path || 'the record'} ${problem.sentence}`;
      return false;
    }
    try {
      const { topic, format, value } = readRecord(record, source);
      client.publish(topic, format, value, { keepSeconds: KEPT_MINUTES * 60 });
      sent.value++;
      sentTo.value = topic;
      error.value = undefined;
      return true;
    } catch (cause) {
      const reason = cause instanceof Error ? cause.message : String(cause);
      error.value = `Not published on ${topicOfJson(record)}: ${reason}`;
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
    sentTo,
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
