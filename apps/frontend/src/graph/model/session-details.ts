import type { Session } from '@ubii/proto';
import type { SessionDetails } from './graph.ts';

export function sessionDetails(session: Session): SessionDetails {
  const { name, description, tags, authors, editable, extension } = session;
  const { startWithMaster = false, lockstepHertz = 0 } = extension ?? {};
  return { name, description, tags, authors, editable, startWithMaster, lockstepHertz };
}

/** Returns the session with these details; the session itself if they are equal. */
export function withDetails(session: Session, details: SessionDetails): Session {
  const { startWithMaster, lockstepHertz, tags, authors, ...rest } = details;
  const { extension } = session;
  const isSame =
    startWithMaster === (extension?.startWithMaster ?? false) &&
    lockstepHertz === (extension?.lockstepHertz ?? 0);
  return {
    ...session,
    ...rest,
    tags: [...tags],
    authors: [...authors],
    extension: isSame ? extension : { ...extensionOf(session), startWithMaster, lockstepHertz },
  };
}

/** Returns the session with this editor data. */
export function withEditorJson(session: Session, editorJson: string): Session {
  if (editorJson === (session.extension?.editorJson ?? '')) return session;
  return { ...session, extension: { ...extensionOf(session), editorJson } };
}

function extensionOf({ extension }: Session): NonNullable<Session['extension']> {
  return (
    extension ?? {
      state: 0,
      problems: [],
      startWithMaster: false,
      lockstepHertz: 0,
      editorJson: '',
      revision: 0,
      stored: false,
      grantIds: [],
      masterId: '',
      movedFrom: '',
      movedMs: 0,
    }
  );
}
