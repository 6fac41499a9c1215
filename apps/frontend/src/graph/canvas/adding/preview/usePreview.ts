import { lazyPatterns } from '@ubii/patterns';
import { watchDebounced } from '@vueuse/core';
import { onScopeDispose, shallowRef, watch, type ShallowRef } from 'vue';
import { useSandboxes } from '../../../../modules/editor/code/useSandboxes.ts';
import { nowMs, usePageReadings } from '../../../../topics/history/page-clock.ts';
import { longestHistory, TopicFeed } from '../../../../topics/history/topic-feeds.ts';
import { useFeedPorts } from '../../../../topics/history/useTopicFeeds.ts';
import { PREVIEW_MS } from './preview-lines.ts';
import type { PreviewRun, PreviewValues } from './preview-run.ts';
import type { PreviewTask } from './preview-task.ts';

/** Values of a preview up to a time. */
export interface PreviewView extends PreviewValues {
  /** This computer's clock, epoch milliseconds. */
  readonly nowMs: number;
}

/** Enough for the time of a preview; the page has one. */
const LIMITS = { maxAgeMs: PREVIEW_MS, maxBytes: 8_000_000 };
/** Time that an entry is selected before it runs, milliseconds: arrow keys pass many. */
const REST_MS = 150;

/**
 * Runs the selected module in a sandbox of this page, on the values of a topic.
 *
 * @returns its values; undefined while it has none, or has an error
 */
export function usePreview(
  topic: () => string | undefined,
  task: () => PreviewTask | undefined,
): Readonly<ShallowRef<PreviewView | undefined>> {
  const ports = useFeedPorts();
  const openSandboxes = useSandboxes();
  const patterns = lazyPatterns();
  const view = shallowRef<PreviewView>();
  let current: { readonly task: PreviewTask; run?: PreviewRun } | undefined;

  // Values are collected from when the palette opens, whichever entry is selected.
  watch(
    topic,
    (name, _before, onCleanup) => {
      if (name === undefined) return;
      const feed = new TopicFeed(name, { ...ports, limits: LIMITS });
      onCleanup(feed.look());
    },
    { immediate: true },
  );

  function end(): void {
    view.value = undefined;
    void current?.run?.close();
    current = undefined;
  }
  async function open(wanted: PreviewTask, startMs: number): Promise<void> {
    const own: typeof current = { task: wanted };
    current = own;
    const [{ PreviewRun: Run }, sandboxes, compiler] = await Promise.all([
      import('./preview-run.ts'),
      openSandboxes(),
      patterns.load(),
    ]);
    if (current !== own) return;
    const run = new Run(wanted, sandboxes, compiler, startMs);
    // A module that cannot be created has no preview: its page says why.
    await run.open().then(
      () => (own.run = run),
      () => run.close(),
    );
    if (current !== own) await run.close();
  }
  async function advance(run: PreviewRun, name: string): Promise<void> {
    const history = longestHistory(name);
    const now = nowMs();
    if (history === undefined || !(await run.advance(history.records, now))) return;
    if (current?.run !== run) return;
    view.value = run.fault === undefined ? { ...run.values, nowMs: now } : undefined;
  }

  const wanted = shallowRef<PreviewTask>();
  watch(task, end);
  watchDebounced(task, (next) => (wanted.value = next), { debounce: REST_MS, immediate: true });
  watch(wanted, end);
  usePageReadings(() => {
    const next = wanted.value;
    if (next === undefined || next !== task()) return;
    if (current === undefined) {
      const oldest = longestHistory(next.topic)?.records.oldest;
      if (oldest !== undefined) void open(next, Math.max(oldest.localMs, nowMs() - PREVIEW_MS));
    } else if (current.run !== undefined) void advance(current.run, next.topic);
  });
  onScopeDispose(end);
  return view;
}
