import { ServiceError, type Session } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
import { randomUuid } from '../../../../connection/random-uuid.ts';
import { newSessionText } from '../../../../locations/session-location.ts';
import type { SessionCalls } from '../../../../sessions/actions/session-calls.ts';
import { sessionCopy, sessionSpec } from '../../../../sessions/text/session-spec.ts';
import { sessionText } from '../../../../sessions/text/session-text.ts';
import { useSessionDraft } from '../../../../sessions/text/useSessionDraft.ts';
import type { GraphEditor } from '../../../editing/graph-editor.ts';

/** A text that is being written, and what it was made from. */
export interface WrittenText {
  readonly base: string;
  readonly text: string;
}

/** The JSON of a session being edited; it stays while the drawer is closed. */
export interface SessionTextDraft {
  /** Undefined while the text is that of the graph. */
  readonly written: Readonly<ShallowRef<WrittenText | undefined>>;
  /** True when the master is asked about the text as soon as it is shown. */
  readonly isChecked: boolean;
  isNew(): boolean;
  /** Text of the graph as it is now, with what is not saved. */
  current(): string;
  write(written: WrittenText): void;
  /** Returns to the text of the graph. */
  drop(): void;
  /** Saves a session that was read from the text, in place of what the graph has. Rejects with the master's reasons. */
  save(read: Session): Promise<Session>;
}

/** @param isGone whether the session is missing on the master, so that saving creates it */
export function useSessionTextDraft(
  editor: GraphEditor,
  calls: SessionCalls,
  isGone: () => boolean,
): SessionTextDraft {
  const kept = useSessionDraft();
  const current = (): string => sessionText(sessionSpec(editor.toSession()));
  const start = isGone() ? newSessionText() : undefined;
  const written = shallowRef<WrittenText>();
  if (start !== undefined && kept.value.trim() !== '')
    written.value = { base: current(), text: kept.value };

  async function send(read: Session): Promise<Session> {
    const spec = sessionSpec(read);
    const { id, name, extension } = editor.session.value;
    if (isGone()) return calls.create({ ...sessionCopy(spec, randomUuid), id });
    const revision = editor.baseSession().extension?.revision ?? 0;
    const changes = { ...spec, extension: { ...spec.extension, revision } };
    if (read.name === name || extension?.stored !== true)
      return calls.update(editor.session.value, changes);
    if ((await calls.takenNames()).has(read.name)) {
      throw new ServiceError(
        'already_exists',
        `Another session has the name "${read.name}". Choose a different name.`,
      );
    }
    return calls.rename(editor.session.value, read.name, changes);
  }

  return {
    written,
    isChecked: start === 'checked',
    isNew: isGone,
    current,
    write(next) {
      written.value = next;
      if (isGone()) kept.value = next.text;
    },
    drop: () => (written.value = undefined),
    async save(read) {
      // Announcements wait: the reply replaces the graph, also what is not saved of it.
      const release = editor.hold(read);
      editor.expect(read);
      try {
        const saved = await send(read);
        editor.adopt(saved);
        written.value = undefined;
        kept.value = '';
        return saved;
      } finally {
        release();
      }
    },
  };
}
