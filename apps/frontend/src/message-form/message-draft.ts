import type { JsonObject, JsonProblem } from '@ubii/proto';
import { computed, ref, shallowRef, type ComputedRef, type Ref, type ShallowRef } from 'vue';
import { jsonPlaces, placeAt, type TextPlace } from './json-places.ts';

/** Problem of a text, with its position. */
export interface PlacedProblem extends TextPlace {
  /** Empty for syntax errors. */
  readonly path: string;
  readonly sentence: string;
}

/** A message that is edited as a form and as JSON at the same time. */
export interface MessageDraft {
  readonly text: Readonly<Ref<string>>;
  /** Parsed value of the text; the last valid one while the text is invalid. */
  readonly json: Readonly<ShallowRef<JsonObject>>;
  readonly problems: ComputedRef<readonly PlacedProblem[]>;
  readonly problemByPath: ComputedRef<ReadonlyMap<string, string>>;
  /** True while the text is valid JSON, and the form shows it. */
  readonly isJson: ComputedRef<boolean>;
  setText(text: string): void;
  setJson(json: JsonObject): void;
}

export const prettyJson = (json: JsonObject): string => JSON.stringify(json, null, 2);

/** @param check returns the problems of a message, apart from its syntax */
export function createMessageDraft(
  initial: JsonObject,
  check: (json: JsonObject) => readonly JsonProblem[],
): MessageDraft {
  const text = ref(prettyJson(initial));
  const json = shallowRef(initial);
  const places = computed(() => jsonPlaces(text.value));
  const isJson = computed(() => places.value.problem === undefined && isObject(text.value));

  const problems = computed((): PlacedProblem[] => {
    const { offsets, problem } = places.value;
    if (problem) return [{ ...problem, path: '' }];
    if (!isJson.value) {
      return [{ path: '', line: 1, column: 1, sentence: 'Expected an object, { … }.' }];
    }
    return check(json.value).map(({ path, sentence }) => ({
      path,
      sentence,
      ...placeAt(text.value, offsets.get(nearest(path, offsets)) ?? 0),
    }));
  });

  return {
    text,
    json,
    problems,
    isJson,
    problemByPath: computed(
      () => new Map(problems.value.map(({ path, sentence }) => [path, sentence])),
    ),
    setText(next) {
      text.value = next;
      if (isJson.value) json.value = JSON.parse(next) as JsonObject;
    },
    setJson(next) {
      json.value = next;
      text.value = prettyJson(next);
    },
  };
}

function isObject(text: string): boolean {
  return text.trimStart().startsWith('{');
}

/** Returns the path, or its nearest ancestor in the text. */
function nearest(path: string, offsets: ReadonlyMap<string, number>): string {
  let around = path;
  while (around !== '' && !offsets.has(around))
    around = around.replace(/(\.|^)[^.[]*$|\[\d+\]$/, '');
  return around;
}
