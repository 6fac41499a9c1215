// @vitest-environment happy-dom
import { afterEach, describe, expect, it } from 'vitest';
import { aSession } from '../../sessions/testing/a-session.ts';
import { createGraphEditor } from '../editing/graph-editor.ts';
import { topicNode } from '../model/make-node.ts';
import { CanvasStage, portKey } from './canvas-stage.ts';
import { ConnectGesture } from './connect-gesture.ts';

const AT = { clientX: 10, clientY: 20 };
const REST = { node: 'module:module', port: 'in:rest' };
const POSITION = { node: 'module:module', port: 'in:position' };
const NUMBER = { node: 'topic:/n', port: 'out' };

function setUp() {
  let count = 0;
  const editor = createGraphEditor(aSession(), () => `uuid-${(count += 1)}`);
  editor.apply({ kind: 'add', nodes: [topicNode('/n', { format: 'double' })] });
  const stage = new CanvasStage(document.createElement('div'));
  stages.push(stage);
  return { editor, gesture: new ConnectGesture(editor, stage, () => []) };
}
const stages: CanvasStage[] = [];
afterEach(() => {
  for (const stage of stages.splice(0)) stage.destroy();
});

describe('pulling a wire', () => {
  const socket = document.createElement('button');

  it('lights what fits, and ends where Enter is pressed', () => {
    const { editor, gesture } = setUp();
    gesture.pressKey(NUMBER, socket);
    expect(gesture.pull.value?.fits.has(portKey(REST))).toBe(true);
    expect(gesture.isMisfit(POSITION)).toBe(true);
    gesture.pressKey(REST, socket);
    expect(gesture.pull.value).toBeUndefined();
    expect([...editor.graph.value.wires.values()].some(({ to }) => to.port === REST.port)).toBe(
      true,
    );
  });

  it('is refused with the reason where it does not fit', () => {
    const { editor, gesture } = setUp();
    const before = editor.graph.value;
    expect(gesture.connect(NUMBER, POSITION, AT)).toBe(false);
    expect(gesture.refusal.value?.fit.reason).toMatch(/outputs double.*expects vector2/);
    expect(editor.graph.value).toBe(before);
    gesture.cancel();
    expect(gesture.refusal.value).toBeUndefined();
  });

  it('takes up the end of a wire that is there, and leads it elsewhere', () => {
    const { editor, gesture } = setUp();
    gesture.connect(NUMBER, REST, AT);
    gesture.pressKey(REST, socket);
    expect(gesture.pull.value?.from).toEqual(NUMBER);
    gesture.cancel();
    expect(editor.graph.value.wires.size).toBe(setUp().editor.graph.value.wires.size + 1);
  });
});
