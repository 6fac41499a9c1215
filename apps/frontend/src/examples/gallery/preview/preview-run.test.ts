import { EXAMPLE_SESSIONS, moduleLibrary } from '@ubii/modules';
import { Re2Patterns } from '@ubii/patterns/re2';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { completeExample } from '../../../sessions/examples/complete-example.ts';
import { GALLERY, type GalleryEntry } from '../gallery.ts';
import { DEMO_INTERVAL_MS, demoInputs } from './demo-input.ts';
import { previewFrame } from './preview-frame.ts';
import { PreviewMemory } from './preview-memory.ts';
import { PreviewRun } from './preview-run.ts';

const library = moduleLibrary();

function setup(entry: GalleryEntry) {
  const clock = new FakeClock();
  const memory = new PreviewMemory(`/examples/${entry.id}/`);
  const topics: string[] = [];
  const run = new PreviewRun(
    completeExample(EXAMPLE_SESSIONS[entry.id], library),
    library,
    { clock, sandboxes: createInlineSandboxes(), patterns: new Re2Patterns() },
    (record) => {
      topics.push(record.topic);
      memory.take(record, clock.monotonicMs());
    },
  );
  return { run, clock, memory, topics };
}

async function demonstrate(entry: GalleryEntry, ms: number) {
  const world = setup(entry);
  await world.run.start();
  for (let atMs = 0; atMs < ms; atMs += DEMO_INTERVAL_MS) {
    for (const record of demoInputs(entry, atMs - DEMO_INTERVAL_MS, atMs)) world.run.put(record);
    await world.clock.advance(DEMO_INTERVAL_MS);
  }
  return world;
}

describe.each(GALLERY.map((entry) => [entry.id, entry] as const))(
  'the preview of %s',
  (_id, entry) => {
    it('shows what its modules compute', async () => {
      const { memory, clock, run } = await demonstrate(entry, 3_000);
      const { view } = entry;
      const frame = previewFrame(view, memory, clock.monotonicMs());
      switch (view.kind) {
        case 'lines':
          for (const { topic } of view.lines) {
            expect(memory.series(topic).length, topic).toBeGreaterThan(20);
          }
          expect(frame.labels).toHaveLength(view.lines.length);
          if (view.events) expect(frame.marks.length).toBeGreaterThan(1);
          if (view.readout) expect(frame.readout).toBeDefined();
          break;
        case 'surface':
          expect(frame.dots).toHaveLength((view.points?.length ?? 0) + 1);
          break;
        case 'color':
          expect(frame.fill).toMatch(/^color\(srgb [\d.]+ [\d.]+ [\d.]+\)$/);
          expect(frame.readout?.text).toMatch(/^#[0-9a-f]{6}$/);
          break;
        case 'count':
          expect(Number(frame.readout?.text)).toBeGreaterThanOrEqual(4);
          break;
        case 'pictures':
          expect(frame.pictures).toHaveLength(view.topics.length);
          break;
        case 'text':
          expect(memory.number('count')).toBeDefined();
          break;
      }
      await run.close();
    });

    it('ends with its modules: nothing is computed after it is closed', async () => {
      const { run, clock, topics } = await demonstrate(entry, 500);
      await run.close();
      const before = topics.length;
      run.put({ topic: `/examples/${entry.id}/pointer`, format: 'vector2', value: { x: 0, y: 0 } });
      await clock.advance(1_000);
      expect(topics).toHaveLength(before);
    });
  },
);

describe('the drawing of lines', () => {
  it('keeps values at the ends of lines apart', () => {
    const memory = new PreviewMemory('/e/');
    const lines = ['a', 'b', 'c'].map((topic) => ({
      topic,
      letter: topic,
      stroke: 'solid' as const,
    }));
    for (const { topic } of lines)
      memory.take({ topic: `/e/${topic}`, format: 'double', value: -1 } as never, 0);
    const { labels } = previewFrame({ kind: 'lines', lines, range: [-1, 1] }, memory, 100);
    const ys = labels.map(({ y }) => y);
    expect(ys[1]! - ys[0]!).toBeGreaterThanOrEqual(15);
    expect(Math.max(...ys)).toBeLessThanOrEqual(160);
  });

  it('forgets what is older than its window', () => {
    const memory = new PreviewMemory('/e/');
    for (let atMs = 0; atMs <= 10_000; atMs += 100) {
      memory.take({ topic: '/e/a', format: 'double', value: atMs } as never, atMs);
    }
    expect(memory.series('a')[0]!.atMs).toBeGreaterThanOrEqual(5_800);
  });
});
