import type { Init, JsonObject, JsonValue, Session } from '@ubii/proto';
import { EDITOR_FORMAT, EDITOR_VERSION } from './editor-format.ts';

/** Longest layout of panels in a session, characters of its JSON: a session is announced as a whole. */
export const MAX_SESSION_PANELS = 32_000;

const isObject = (value: unknown): value is JsonObject =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** @returns `undefined` for editor data of another program */
function editorData(session: Session): JsonObject | undefined {
  const text = session.extension?.editorJson ?? '';
  if (text === '') return { format: EDITOR_FORMAT, version: EDITOR_VERSION };
  try {
    const json: unknown = JSON.parse(text);
    const isOurs =
      isObject(json) && json['format'] === EDITOR_FORMAT && json['version'] === EDITOR_VERSION;
    return isOurs ? json : undefined;
  } catch {
    return undefined;
  }
}

/** Returns the layout of panels that is saved with a session, as unvalidated JSON; `undefined` without one. */
export function sessionPanels(session: Session): JsonValue | undefined {
  // Most sessions have none: do not parse their editor data.
  if (!(session.extension?.editorJson ?? '').includes('"panels"')) return undefined;
  return editorData(session)?.['panels'];
}

/**
 * Returns the change that saves a layout with a session; graph editors keep it, because they do not know it. [EX-101]
 * @returns a sentence when the session cannot have it
 */
export function withSessionPanels(session: Session, layout: JsonObject): Init<Session> | string {
  if (JSON.stringify(layout).length > MAX_SESSION_PANELS) {
    return 'This layout is too large for a session. Remove panels, or export it as a file.';
  }
  const data = editorData(session);
  if (data === undefined) {
    return 'The layout of this session was made by another program. Export the panels as a file instead.';
  }
  return { extension: { editorJson: JSON.stringify({ ...data, panels: layout }) } };
}
