// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it } from 'vitest';
import { addables } from './addable.ts';
import { aGraphDesk, LOOSE, output, type GraphDesk } from './testing/graph-desk.ts';

let desk: GraphDesk;
beforeEach(async () => {
  desk = await aGraphDesk();
});
afterEach(() => desk.close());

/** Returns the nodes that came with an action. */
function addedBy(act: () => void): string[] {
  const { editor } = desk;
  const before = editor.graph.value.nodes;
  act();
  return [...editor.graph.value.nodes.keys()].filter((id) => !before.has(id));
}

it('a node added by its name is selected', () => {
  const { editor, adding } = desk;
  const [note] = addables(editor.graph.value, { modules: [], topics: [] }, 'note', undefined);
  const added = addedBy(() => {
    adding.askInMiddle();
    adding.choose(note!);
  });
  expect([...editor.selection.value.nodes]).toEqual(added);
});

it('a topic added at the end of a dropped wire is selected', () => {
  const { editor, adding } = desk;
  const end = output(LOOSE);
  const [topic] = addables(editor.graph.value, { modules: [], topics: [] }, '/new', end);
  const added = addedBy(() => {
    adding.askAt(0, 0, { from: end, side: 'out' });
    adding.choose(topic!);
  });
  expect(added).toHaveLength(1);
  expect([...editor.selection.value.nodes]).toEqual(added);
});
