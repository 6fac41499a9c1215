import { isDataFormat, type DataFormat, type JsonObject, type JsonValue } from '@ubii/proto';
import type { TopicRecord } from '@ubii/proto';
import { computed, ref, watch, type ComputedRef, type Ref, type WritableComputedRef } from 'vue';
import { saveFile } from '../files/save-file.ts';
import { provideFormProblems } from '../message-form/form-problems.ts';
import { valueJson } from '../topics/values/value-json.ts';
import { useGesture, type GestureDeck } from './gesture/useGesture.ts';
import { formatOfJson, newRecord, topicOfJson } from './record-json.ts';
import { snippetsFile, withSnippet, type Snippet } from './snippets.ts';
import { useLiveSending } from './useLiveSending.ts';
import { RATE_HZ, usePublisher, type Publisher } from './usePublisher.ts';

/** A record that is edited and published: as a form, as JSON, as a gesture. */
export interface Publishing {
  readonly publisher: Publisher;
  readonly topic: WritableComputedRef<string>;
  readonly format: WritableComputedRef<DataFormat>;
  /** The value of the record, as JSON. */
  readonly value: ComputedRef<JsonValue | undefined>;
  /** Rate of the repetition, as typed. */
  readonly rate: Ref<string>;
  readonly rateProblem: ComputedRef<string | undefined>;
  /** The last valid rate. */
  readonly rateHz: Readonly<Ref<number>>;
  /** Publishes each change of the value. */
  readonly isLive: Ref<boolean>;
  readonly deck: GestureDeck;
  setValue(next: JsonValue | undefined): void;
  repeat(): void;
  exportGesture(): void;
  openSnippet(snippet: Snippet): void;
}

/** Record with the value of another one; the default value of its format without it. */
export function recordFrom(topic: string, record: TopicRecord | undefined): JsonObject {
  return record !== undefined && isDataFormat(record.format)
    ? { topic, [record.format]: valueJson(record) }
    : newRecord(topic, 'double');
}

/** Edits one record and publishes it, while the calling component is mounted. */
export function usePublishing(first = newRecord('', 'double')): Publishing {
  const publisher = usePublisher(first);
  const { draft, isRepeating } = publisher;
  provideFormProblems(draft.problemByPath);

  /** The value last entered for each data format, restored when the format is chosen again. */
  const typed = new Map<DataFormat, JsonObject[string]>();
  const topic = computed({
    get: () => topicOfJson(draft.json.value),
    set: (next) => draft.setJson({ ...draft.json.value, topic: next }),
  });
  const format = computed({
    get: () => formatOfJson(draft.json.value) ?? 'double',
    set(next) {
      typed.set(format.value, draft.json.value[format.value]!);
      const fresh = newRecord(topic.value, next);
      draft.setJson(typed.has(next) ? { ...fresh, [next]: typed.get(next)! } : fresh);
    },
  });
  const value = computed(() => draft.json.value[format.value]);

  const rate = ref('10');
  const typedRateHz = computed(() => Number(rate.value.replace(',', '.')));
  const rateProblem = computed(() =>
    typedRateHz.value >= RATE_HZ.least && typedRateHz.value <= RATE_HZ.most
      ? undefined
      : `Enter ${RATE_HZ.least} to ${RATE_HZ.most} Hz.`,
  );
  const rateHz = ref(typedRateHz.value);
  watch(typedRateHz, (hz) => {
    if (rateProblem.value !== undefined) return;
    rateHz.value = hz;
    if (isRepeating.value) publisher.repeat(hz);
  });

  const isLive = ref(false);
  useLiveSending(() => ({ format: format.value, value: value.value }), isLive, publisher.send);

  const deck = useGesture(
    () => format.value,
    () => value.value,
    (played, next) => publisher.sendRecord({ topic: topic.value, [played]: next }),
  );
  watch(deck.state, (state) => state === 'playing' && publisher.stop());

  return {
    publisher,
    topic,
    format,
    value,
    rate,
    rateProblem,
    rateHz,
    isLive,
    deck,
    setValue: (next) => draft.setJson({ ...draft.json.value, [format.value]: next ?? null }),
    repeat() {
      if (rateProblem.value === undefined) publisher.repeat(rateHz.value);
    },
    exportGesture() {
      const gesture = deck.gesture.value;
      if (!gesture) return;
      const one = withSnippet([], 'gesture', draft.text.value, rateHz.value, gesture);
      saveFile({ ...snippetsFile(one), name: 'gesture.json' });
    },
    openSnippet({ text, rateHz: hz, gesture }) {
      draft.setText(text);
      rate.value = String(hz);
      deck.open(gesture);
    },
  };
}
