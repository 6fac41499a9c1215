import type { JsonObject } from '@ubii/proto';
import {
  computed,
  onScopeDispose,
  ref,
  shallowRef,
  watch,
  type ComputedRef,
  type Ref,
  type ShallowRef,
} from 'vue';
import { KEPT_MINUTES } from '../connection/kept-minutes.ts';
import { useConnection } from '../connection/useConnection.ts';
import { draftReason } from '../message-form/draft-reason.ts';
import { createMessageDraft, type MessageDraft } from '../message-form/message-draft.ts';
import { checkRecord, newRecord, readRecord, topicOfJson } from './record-json.ts';
import { variableSource } from './variables.ts';

/** Limits of the repeat rate, records per second. */
export const RATE_HZ = { least: 0.1, most: 100 } as const;

/** Edits the record of this page, and publishes it once or repeatedly. */
export interface Publisher {
  readonly draft: MessageDraft;
  /** Reason why the record cannot be published now, one sentence; undefined when it can. */
  readonly reason: ComputedRef<string | undefined>;
  /** Number of records published since the page was opened. */
  readonly sent: Readonly<Ref<number>>;
  /** Topic of the last record; empty before the first. */
  readonly sentTo: Readonly<Ref<string>>;
  /** Reason why the last record was not published, one sentence; until the next edit. */
  readonly error: Readonly<ShallowRef<string | undefined>>;
  readonly isRepeating: Readonly<Ref<boolean>>;
  send(): boolean;
  /** Publishes this record instead of the one on the page. */
  sendRecord(record: JsonObject): boolean;
  /** Publishes now and repeatedly at this rate, until `stop` or until the page is left. */
  repeat(rateHz: number): void;
  stop(): void;
}

/** @param first the record to begin with */
export function usePublisher(first = newRecord('', 'double')): Publisher {
  const { client, isConnected } = useConnection();
  const sent = ref(0);
  const sentTo = ref('');
  const error = shallowRef<string>();
  const isRepeating = ref(false);
  const source = variableSource(() => sent.value);
  const draft = createMessageDraft(first, (json) => checkRecord(json, source));
  const reason = computed(() =>
    isConnected.value ? draftReason(draft) : 'This page is not connected to the master.',
  );
  let timer: ReturnType<typeof setInterval> | undefined;

  onScopeDispose(
    client.onError((problem) => {
      error.value = problem.message;
    }),
  );

  watch(draft.text, () => (error.value = undefined), { flush: 'sync' });

  function send(): boolean {
    if (reason.value === undefined) return sendRecord(draft.json.value);
    error.value = `Not published: ${reason.value}`;
    return false;
  }
  function sendRecord(record: JsonObject): boolean {
    if (!isConnected.value) {
      error.value = 'Not published: this page is not connected to the master.';
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
    draft,
    reason,
    sent,
    sentTo,
    error,
    isRepeating,
    send,
    sendRecord,
    stop,
    repeat(rateHz) {
      stop();
      const hz = Math.min(RATE_HZ.most, Math.max(RATE_HZ.least, rateHz));
      isRepeating.value = true;
      send();
      timer = setInterval(send, 1000 / hz);
    },
  };
}
