import { lazyPatterns } from '@ubii/patterns';
import type { ModuleFault, SandboxFactory, SandboxResult } from '@ubii/pm-sandbox';
import { decodeRecord, ModuleEventKind, type ModuleEvent, type TopicRecord } from '@ubii/proto';
import { systemClock } from '@ubii/timing/system';
import { watchDebounced } from '@vueuse/core';
import {
  computed,
  onScopeDispose,
  shallowReactive,
  shallowRef,
  watch,
  type ComputedRef,
  type ShallowRef,
} from 'vue';
import { perFrame } from '../../../connection/per-frame.ts';
import { useTopic } from '../../../connection/live/useTopic.ts';
import { useConnection } from '../../../connection/useConnection.ts';
import { withEvent } from '../../../sessions/live/event-log.ts';
import { sparkNumbers } from '../../../topics/values/value-series.ts';
import type { EditedModule } from '../../draft/edited-module.ts';
import { moduleOf } from '../../draft/module-draft.ts';
import { newTryInput, recordsOf, tryMapping, type TryInput } from './try-input.ts';
import { TryRun, type TryStatus } from './try-run.ts';

/** Newest value of an output. */
export interface TryOutput {
  readonly records: readonly { readonly record: TopicRecord; readonly name: string }[];
  /** First number of previous values, oldest first. */
  readonly series: readonly number[];
}

/** Statistics of recent runs. */
export interface TryRuns {
  readonly count: number;
  /** Durations of recent runs, milliseconds, oldest first. */
  readonly durationsMs: readonly number[];
}

export interface TrySession {
  readonly status: Readonly<ShallowRef<TryStatus>>;
  readonly runs: Readonly<ShallowRef<TryRuns>>;
  readonly outputs: Readonly<ShallowRef<ReadonlyMap<string, TryOutput>>>;
  readonly events: Readonly<ShallowRef<readonly ModuleEvent[]>>;
  /** Reason why it ended: killed, or could not be created. */
  readonly fault: Readonly<ShallowRef<ModuleFault | undefined>>;
  /** True when code, inputs, outputs or mode changed since the start. */
  readonly isOutdated: ComputedRef<boolean>;
  readonly inputProblems: ComputedRef<ReadonlyMap<string, string>>;
  inputOf(name: string): TryInput | undefined;
  setInput(name: string, change: Partial<TryInput>): void;
  step(): Promise<void>;
  run(): Promise<void>;
  pause(): void;
  /** Restarts with an empty state; continues running if it was. */
  restart(): Promise<void>;
}

/** Most runs in the chart. */
const MAX_DURATIONS = 64;
const MAX_SERIES = 120;
/** Interval of lockstep passes, the default of sessions, milliseconds. [SE-40] */
const PASS_MS = 1000 / 60;
/** Pause in typing after which changed code runs, milliseconds. */
const RENEW_MS = 600;
const NO_RUNS: TryRuns = { count: 0, durationsMs: [] };

/** @param mayRun whether the code parses */
export function useTryRun(
  { draft, about, code }: EditedModule,
  openSandboxes: () => Promise<SandboxFactory>,
  mayRun: () => boolean,
): TrySession {
  const { client } = useConnection();
  const status = shallowRef<TryStatus>('off');
  const runs = shallowRef<TryRuns>(NO_RUNS);
  const outputs = shallowRef<ReadonlyMap<string, TryOutput>>(new Map());
  const events = shallowRef<readonly ModuleEvent[]>([]);
  const fault = shallowRef<ModuleFault>();
  const inputs = shallowReactive(new Map<string, { key: string; input: TryInput }>());
  const opened = shallowRef('');

  const patterns = lazyPatterns();
  let current: Promise<TryRun> | undefined;
  let count = 0;
  let durations: number[] = [];
  let results = new Map<string, SandboxResult['outputs'][number]>();
  let waiting: ModuleEvent[] = [];
  /** True after it was started and neither paused nor stepped since; it may have ended by itself. */
  const isActive = shallowRef(false);
  let passes: ReturnType<typeof setInterval> | undefined;
  const endPasses = (): void => clearInterval(passes);

  const draw = perFrame(() => {
    runs.value = { count, durationsMs: [...durations] };
    if (results.size > 0) {
      const next = new Map(outputs.value);
      for (const [name, output] of results) next.set(name, shown(output, next.get(name)));
      results = new Map();
      outputs.value = next;
    }
    if (waiting.length > 0) events.value = withEvent(events.value, waiting);
    waiting = [];
  });

  function handleResult({ durationMs, outputs: given }: SandboxResult): void {
    count += 1;
    durations = [...durations.slice(1 - MAX_DURATIONS), durationMs];
    for (const output of given) results.set(output.name, output);
    draw();
  }

  function open(): Promise<TryRun> {
    return (current ??= Promise.all([openSandboxes(), patterns.load()]).then(
      ([sandboxes, compiler]) =>
        new TryRun(sandboxes, compiler, systemClock, {
          onResult: handleResult,
          onFailedRun() {
            count += 1;
            draw();
          },
          onEvent(event) {
            // `FAILED` repeats the message of the preceding kill.
            if (event.kind === ModuleEventKind.FAILED) return;
            waiting.push(event);
            draw();
          },
          onStatus: (next) => (status.value = next),
          onFault: (found) => (fault.value = found),
        }),
    ));
  }

  const what = (): string => {
    const { inputs: takes, outputs: gives, mode } = about.value;
    return JSON.stringify([code.value, takes, gives, mode]);
  };
  const inputOf = (name: string): TryInput | undefined => inputs.get(name)?.input;

  watch(
    () => about.value.inputs,
    (list) => {
      for (const io of list) {
        const key = JSON.stringify(io);
        if (inputs.get(io.name)?.key !== key) inputs.set(io.name, { key, input: newTryInput(io) });
      }
    },
    { immediate: true },
  );

  const declared = computed(() => about.value.inputs);
  const given = computed(() =>
    declared.value.map((io) => {
      const input = inputOf(io.name);
      return { io, read: input ? recordsOf(io, input) : { records: [] } };
    }),
  );
  const lives = computed(() =>
    declared.value.flatMap((io) => {
      const input = inputOf(io.name);
      return input?.source === 'topic' && input.topic !== ''
        ? [io.isList ? { glob: input.topic } : input.topic]
        : [];
    }),
  );

  function putAll(run: TryRun): void {
    const records = given.value.flatMap(({ read }) => ('records' in read ? read.records : []));
    for (const { topic, bytes } of records) run.topics.put(topic, bytes, client.id);
  }
  const mapping = () => tryMapping(about.value, inputOf);

  // Typed values apply at once, as if they were published.
  watch(
    () => JSON.stringify([...inputs.values()]),
    async () => {
      if (!current || status.value === 'off') return;
      const run = await current;
      run.remap(mapping());
      putAll(run);
    },
  );

  // Newest records of live topics, while the pane is visible.
  useTopic(lives, {
    encoded: true,
    keep: 0,
    onRecord({ topic, bytes, publisherId }) {
      void open().then((run) => run.topics.put(topic, bytes, publisherId));
    },
  });

  async function restart(): Promise<void> {
    const run = await open();
    count = 0;
    durations = [];
    results = new Map();
    waiting = [];
    outputs.value = new Map();
    events.value = [];
    fault.value = undefined;
    runs.value = NO_RUNS;
    opened.value = what();
    putAll(run);
    await run.open(moduleOf(draft.value), mapping());
  }
  /** Creates it again; continues running if it was. */
  async function renew(): Promise<void> {
    const wasRunning = isActive.value;
    endPasses();
    await restart();
    if (wasRunning && status.value === 'ready') await go();
  }
  const isOutdated = computed(() => status.value !== 'off' && opened.value !== what());

  // Changed code applies while running, as in sessions. [SE-26]
  watchDebounced(
    what,
    async () => {
      if (isActive.value && isOutdated.value && mayRun()) await renew();
    },
    { debounce: RENEW_MS },
  );

  async function ready(): Promise<TryRun> {
    const run = await open();
    if (status.value === 'off' || status.value === 'failed' || isOutdated.value) await restart();
    return run;
  }

  async function go(): Promise<void> {
    isActive.value = true;
    const run = await ready();
    run.run();
    // Triggers modules that wait for inputs with the current ones.
    putAll(run);
    endPasses();
    if (!run.isLockstep || run.status !== 'running') return;
    passes = setInterval(() => void run.pass(PASS_MS), PASS_MS);
  }

  onScopeDispose(() => {
    endPasses();
    void current?.then((run) => run.close());
  });

  return {
    status,
    runs,
    outputs,
    events,
    fault,
    isOutdated,
    inputProblems: computed(
      () =>
        new Map(
          given.value.flatMap(({ io, read }) =>
            'problem' in read ? [[io.name, read.problem] as const] : [],
          ),
        ),
    ),
    inputOf,
    setInput(name, change) {
      const entry = inputs.get(name);
      if (entry) inputs.set(name, { ...entry, input: { ...entry.input, ...change } });
    },
    async step() {
      isActive.value = false;
      endPasses();
      const run = await ready();
      if (status.value === 'failed') return;
      await run.step();
    },
    run: go,
    pause() {
      isActive.value = false;
      endPasses();
      void current?.then((run) => run.pause());
    },
    restart: renew,
  };
}

type Given = SandboxResult['outputs'][number];

function shown(output: Given, before: TryOutput | undefined): TryOutput {
  const values =
    'value' in output
      ? [{ value: output.value, name: '' }]
      : output.elements.map(({ value, identity, params, index }) => ({
          value,
          name: params?.join(', ') ?? identity ?? String(index + 1),
        }));
  const records = values.flatMap(({ value, name }) => {
    const record = decodeRecord(value.bytes);
    return record.format === undefined ? [] : [{ record, name }];
  });
  const first = records[0]?.record;
  const [number] = first ? sparkNumbers(first.format, first.value) : [];
  const series = before?.series ?? [];
  return {
    records,
    series: number === undefined ? series : [...series.slice(1 - MAX_SERIES), number],
  };
}
