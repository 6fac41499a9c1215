import { createClient } from '@ubii/client-web/node';
import { MasterProcess } from '@ubii/harness';

import type { WorkloadSetting } from '../measuring/workload.ts';
import { startSession, writeModuleFolder } from '../modules/running-session.ts';
import {
  startCanvasBrowser,
  type CanvasBrowser,
  type CanvasPage,
  type Point,
} from './canvas-page.ts';
import { SOURCE_HERTZ, ADDER, largeSession, type LargeSession } from './large-session.ts';
import { serveBareCanvas, type BareCanvas } from './serve-bare-canvas.ts';

/** Publishes a number to each topic, many times a second, until it is stopped. */
async function publishSources(
  url: string,
  topics: readonly string[],
): Promise<{ stop(): Promise<void> }> {
  const client = createClient({ url, name: 'benchmark sources' });
  await client.connect();
  let count = 0;
  const timer = setInterval(() => {
    count += 1;
    topics.forEach((topic, index) =>
      client.publish(topic, 'double', 100 * index + Math.sin(count / 10)),
    );
  }, 1000 / SOURCE_HERTZ);
  return {
    stop: async () => {
      clearInterval(timer);
      await client.close();
    },
  };
}

/** A graph drawn in a page, and where its canvas is. */
export interface OpenGraph {
  readonly canvas: CanvasPage;
  readonly middle: Point;
  /** From navigation until all nodes were drawn, ms. */
  readonly openMs: number;
}

/** An implementation that draws graphs: the editor, or a minimal baseline. */
export interface GraphSubject {
  readonly name: string;
  readonly nodeCount: number;
  open(): Promise<OpenGraph>;
}

/** About as large as the canvas of the editor beside its palette and inspector. */
const BARE_VIEWPORT = { width: 888, height: 840 };

export const REFERENCE = 'bare page';
export const EDITOR = 'graph editor';

export async function openGraphSubjects(
  { parts, master: file, profileDir }: WorkloadSetting,
  size: { readonly modules: number; readonly showsTopics: boolean; readonly isRunning: boolean },
): Promise<{ subjects: readonly GraphSubject[]; master: MasterProcess }> {
  const folder = await parts.get('modules', () => writeModuleFolder([ADDER]));
  const master = await parts.get('master', () =>
    MasterProcess.start({ program: file, profileDir, flags: ['--modules', folder.path] }),
  );
  const browser = await parts.get('browser', startCanvasBrowser);
  const bare = await parts.get('bare canvas', serveBareCanvas);
  const graph = largeSession(`graph-${size.modules}`, size.modules, size.showsTopics);
  const { id } = await parts.get(`session ${size.modules}`, () =>
    size.isRunning ? run(master, graph) : add(master, graph),
  );
  return {
    subjects: [bareSubject(browser, bare, graph), editorSubject(browser, master, graph, id)],
    master,
  };
}

async function run(master: MasterProcess, { session, sources }: LargeSession) {
  const publisher = await publishSources(master.url, sources);
  const running = await startSession(master, session);
  return {
    id: running.id,
    stop: async () => {
      await publisher.stop();
      await running.stop();
    },
  };
}

async function add(master: MasterProcess, { session }: LargeSession) {
  const reply = await master.call({ topic: '/services/session/runtime/add', session });
  if (reply.session === undefined) throw new Error('The master took no session.');
  return { id: reply.session.id, stop: () => Promise.resolve() };
}

function bareSubject(browser: CanvasBrowser, bare: BareCanvas, { nodeCount }: LargeSession) {
  return {
    name: REFERENCE,
    nodeCount,
    async open(): Promise<OpenGraph> {
      const canvas = await browser.open(bare.url(nodeCount));
      await canvas.page.setViewportSize(BARE_VIEWPORT);
      const openMs = await canvas.watch('ready', nodeCount);
      const { width, height } = BARE_VIEWPORT;
      return { canvas, openMs, middle: { x: width / 2, y: height / 2 } };
    },
  };
}

function editorSubject(
  browser: CanvasBrowser,
  master: MasterProcess,
  { nodeCount }: LargeSession,
  id: string,
) {
  return {
    name: EDITOR,
    nodeCount,
    async open(): Promise<OpenGraph> {
      const canvas = await browser.open(`${master.url}/sessions/${id}/graph`);
      const openMs = await canvas.watch('ready', nodeCount);
      const box = (await canvas.page.getByRole('application').boundingBox())!;
      return { canvas, openMs, middle: { x: box.x + box.width / 2, y: box.y + box.height / 2 } };
    },
  };
}
