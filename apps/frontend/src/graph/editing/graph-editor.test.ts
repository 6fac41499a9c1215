import type { Session } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { aSession } from '../../sessions/testing/a-session.ts';
import { topicNode } from '../model/make-node.ts';
import { createGraphEditor, type GraphEditor } from './graph-editor.ts';

let count = 0;
const uuid = (): string => `uuid-${(count += 1)}`;
const editorOf = (session: Session): GraphEditor => createGraphEditor(session, uuid);
const withRevision = (revision: number, name = 'Two hands'): Session => {
  const session = aSession({ name });
  return { ...session, extension: { ...session.extension!, revision } };
};
const addTopic = (editor: GraphEditor, topic: string): void =>
  editor.apply({ kind: 'add', nodes: [topicNode(topic)] });

describe('the graph editor', () => {
  it('counts what is not saved, and takes it back', () => {
    const editor = editorOf(aSession());
    expect(editor.changes.value).toBe(0);
    addTopic(editor, '/b');
    addTopic(editor, '/c');
    expect(editor.changes.value).toBe(2);
    editor.undo();
    expect(editor.graph.value.nodes.has('topic:/c')).toBe(false);
    editor.redo();
    expect(editor.graph.value.nodes.has('topic:/c')).toBe(true);
    editor.undo();
    editor.undo();
    expect(editor.undoLabel.value).toBeUndefined();
  });

  it('adopts a session that was saved as a text as one step that can be undone', () => {
    const editor = editorOf(withRevision(3));
    addTopic(editor, '/b');
    const before = editor.graph.value;
    const { extension } = withRevision(4);
    editor.adopt({ ...aSession({ name: 'As text' }), extension: extension! });
    expect(editor.graph.value.details.name).toBe('As text');
    expect(editor.graph.value.nodes.has('topic:/b')).toBe(false);
    expect(editor.changes.value).toBe(0);
    expect(editor.undoLabel.value).toBe('Apply JSON');
    editor.undo();
    expect(editor.graph.value).toEqual(before);
    // What the master has is the text.
    expect(editor.changes.value).toBe(1);
    editor.redo();
    expect(editor.changes.value).toBe(0);
    editor.undo();
    editor.undo();
    expect(editor.undoLabel.value).toBeUndefined();
  });

  it('selects only what is there', () => {
    const editor = editorOf(aSession());
    addTopic(editor, '/b');
    editor.select(['topic:/b', 'module:module']);
    editor.undo();
    expect([...editor.selection.value.nodes]).toEqual(['module:module']);
  });

  it('has a place for every node, and saves it', () => {
    const editor = editorOf(aSession());
    expect([...editor.places.value.keys()].sort()).toEqual(
      [...editor.graph.value.nodes.keys()].sort(),
    );
    const again = editorOf(editor.toSession());
    expect(again.places.value).toEqual(editor.places.value);
  });

  it('has nothing to save after saving, also when the news of it come before the answer', () => {
    const editor = editorOf(aSession());
    addTopic(editor, '/b');
    const mark = editor.mark();
    const sent = editor.toSession();
    const answer = { ...sent, extension: { ...sent.extension!, revision: 4 } };
    editor.handleSession(answer);
    editor.handleSaved(answer, mark);
    expect(editor.changes.value).toBe(0);
    expect(editor.merged.value).toBeUndefined();
    addTopic(editor, '/c');
    expect(editor.changes.value).toBe(1);
  });

  it('has nothing to save after saving, but what was done meanwhile', () => {
    const editor = editorOf(aSession());
    addTopic(editor, '/b');
    const mark = editor.mark();
    addTopic(editor, '/c');
    editor.handleSaved(withRevision(4), mark);
    expect(editor.changes.value).toBe(1);
    editor.undo();
    expect(editor.changes.value).toBe(0);
  });

  it('recognises its own save when the reply was lost and the announcement arrives', () => {
    const editor = editorOf(withRevision(3));
    addTopic(editor, '/b');
    const sent = editor.toSession();
    const release = editor.hold(sent);
    editor.handleSession({ ...sent, extension: { ...sent.extension!, revision: 4 } });
    release();
    expect(editor.news.value).toBeUndefined();
    expect(editor.merged.value).toBeUndefined();
    expect(editor.changes.value).toBe(0);
    expect(editor.toSession().extension?.revision).toBe(4);
    editor.undo();
    expect(editor.graph.value.nodes.has('topic:/b')).toBe(false);
  });

  it('recognises its own save also when it was changed further meanwhile', () => {
    const editor = editorOf(withRevision(3));
    addTopic(editor, '/b');
    const sent = editor.toSession();
    const release = editor.hold(sent);
    addTopic(editor, '/c');
    release();
    editor.handleSession({ ...sent, extension: { ...sent.extension!, revision: 4 } });
    expect(editor.news.value).toBeUndefined();
    expect(editor.merged.value).toBeUndefined();
    expect(editor.changes.value).toBe(1);
  });

  it('recognises a save that the page sent before it was reloaded', () => {
    const before = editorOf(withRevision(3));
    addTopic(before, '/b');
    const sent = before.toSession();
    const reloaded = editorOf(withRevision(3));
    reloaded.expect(sent);
    reloaded.handleSession({ ...sent, extension: { ...sent.extension!, revision: 4 } });
    expect(reloaded.news.value).toBeUndefined();
    expect(reloaded.graph.value.nodes.has('topic:/b')).toBe(true);
    expect(reloaded.changes.value).toBe(0);
  });

  it('reports what another client saved instead of the save that was lost', () => {
    const editor = editorOf(withRevision(3));
    addTopic(editor, '/b');
    editor.hold(editor.toSession())();
    editor.handleSession(withRevision(4, 'Renamed'));
    expect(editor.news.value?.changes.map(({ words }) => words)).toEqual([
      'renamed the session to Renamed',
    ]);
    expect(editor.changes.value).toBe(1);
  });

  it('shows what others saved while nothing was changed here', () => {
    const editor = editorOf(withRevision(3));
    editor.handleSession(withRevision(4, 'Renamed'));
    expect(editor.graph.value.details.name).toBe('Renamed');
    expect(editor.merged.value).toBeUndefined();
  });

  it('puts changes on top of what others saved meanwhile', () => {
    const editor = editorOf(withRevision(3));
    addTopic(editor, '/b');
    editor.handleSession(withRevision(4, 'Renamed'));
    expect(editor.merged.value).toEqual([]);
    expect(editor.graph.value.details.name).toBe('Renamed');
    expect(editor.graph.value.nodes.has('topic:/b')).toBe(true);
    expect(editor.toSession().extension?.revision).toBe(4);
    editor.undo();
    expect(editor.changes.value).toBe(0);
  });

  it('names what both changed, keeps mine, and takes theirs when asked', () => {
    const editor = editorOf(withRevision(3));
    editor.apply({ kind: 'setDetails', changes: { name: 'Mine' } });
    editor.handleSession(withRevision(4, 'Theirs'));
    expect(editor.graph.value.details.name).toBe('Mine');
    const [conflict] = editor.merged.value ?? [];
    editor.takeTheirs(conflict!);
    expect(editor.graph.value.details.name).toBe('Theirs');
    expect(editor.merged.value).toEqual([]);
  });

  it('puts changes on top of what a restarted master has, whatever its revision [SE-27]', () => {
    const editor = editorOf(withRevision(7, 'Not stored'));
    addTopic(editor, '/b');
    const reopened = withRevision(6, 'As stored');
    editor.handleSession(reopened);
    expect(editor.graph.value.details.name).toBe('Not stored');
    editor.handleSession(reopened, true);
    expect(editor.graph.value.details.name).toBe('As stored');
    expect(editor.graph.value.nodes.has('topic:/b')).toBe(true);
    expect(editor.baseSession().extension?.revision).toBe(6);
    expect(editor.changes.value).toBe(1);
  });

  it('keeps changes and their undo when a restarted master has what it had', () => {
    const editor = editorOf(withRevision(7));
    addTopic(editor, '/b');
    editor.handleSession(withRevision(6), true);
    expect(editor.news.value).toBeUndefined();
    expect(editor.baseSession().extension?.revision).toBe(6);
    editor.undo();
    expect(editor.changes.value).toBe(0);
  });

  it('finds no conflict in where each run of the master puts a module', () => {
    const placed = (nodeId: string, revision: number): Session => {
      const session = withRevision(revision);
      const [module] = session.processingModules;
      const extension = { ...module!.extension!, replaceable: true };
      return { ...session, processingModules: [{ ...module!, nodeId, extension }] };
    };
    const unplaced = withRevision(7);
    unplaced.processingModules[0]!.nodeId = '';
    const editor = editorOf(placed('new master', 8));
    editor.resume(placed('old master', 7), { ...unplaced, name: 'Renamed' });
    expect(editor.merged.value).toBeUndefined();
    expect(editor.graph.value.details.name).toBe('Renamed');
    expect(editor.toSession().processingModules[0]).toMatchObject({
      nodeId: 'new master',
      extension: { replaceable: true },
    });
  });

  it('hears how the session lives without losing changes', () => {
    const editor = editorOf(withRevision(3));
    addTopic(editor, '/b');
    const living = withRevision(3);
    editor.handleSession({ ...living, extension: { ...living.extension!, state: 2 } });
    expect(editor.session.value.extension?.state).toBe(2);
    expect(editor.changes.value).toBe(1);
  });

  it('continues with a draft as something that is not saved', () => {
    const editor = editorOf(aSession());
    addTopic(editor, '/b');
    const draft = editor.toSession();
    const reloaded = editorOf(aSession());
    reloaded.resume(editor.baseSession(), draft);
    expect(reloaded.graph.value.nodes.has('topic:/b')).toBe(true);
    expect(reloaded.changes.value).toBeGreaterThan(0);
  });
});
