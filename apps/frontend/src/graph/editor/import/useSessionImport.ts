import type { Session } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
import { useRouter, type RouteLocationRaw } from 'vue-router';
import { randomUuid } from '../../../connection/random-uuid.ts';
import { tryRequest } from '../../../connection/useAttempt.ts';
import { useConnection } from '../../../connection/useConnection.ts';
import { newTextLocation } from '../../../locations/session-location.ts';
import type { SessionCalls } from '../../../sessions/actions/session-calls.ts';
import { knownModules } from '../../../sessions/file/known-modules.ts';
import { openSessionFile } from '../../../sessions/file/open-session-file.ts';
import { sessionCopy, sessionSpec } from '../../../sessions/text/session-spec.ts';
import { sessionText } from '../../../sessions/text/session-text.ts';
import { useSessionDraft } from '../../../sessions/text/useSessionDraft.ts';
import { useToasts } from '../../../ui/toasts/toasts.ts';
import { preparedFile, type PreparedFile } from './prepared-file.ts';

/** Import of files as sessions. */
export interface SessionImport {
  readonly isReading: Readonly<ShallowRef<boolean>>;
  /** Parsed files that wait for the user's confirmation. */
  readonly asked: Readonly<ShallowRef<readonly PreparedFile[] | undefined>>;
  /** Reads files. Creates sessions at once, unless there are questions or warnings. */
  take(files: readonly File[]): Promise<void>;
  /** Creates a session from each valid file. */
  create(): Promise<void>;
  /** Opens the text of an invalid file in the editor. */
  edit(text: string): Promise<void>;
  cancel(): void;
}

/** Options of a page that imports sessions. */
export interface ImportOptions {
  readonly calls: SessionCalls;
  /** Whether users must confirm every import, also without warnings. */
  readonly isAsking?: () => boolean;
  readonly locationOf: (sessionId: string) => RouteLocationRaw;
}

/** Creates sessions from files; used by the list of sessions and the graph editor. */
export function useSessionImport({ calls, isAsking, locationOf }: ImportOptions): SessionImport {
  const { client } = useConnection();
  const router = useRouter();
  const toasts = useToasts();
  const draft = useSessionDraft();
  const asked = shallowRef<readonly PreparedFile[]>();
  const isReading = shallowRef(false);

  async function edit(text: string): Promise<void> {
    asked.value = undefined;
    draft.value = text;
    await router.push(newTextLocation(true));
  }

  /** @returns undefined when the master refused it; its text is then open with the reasons */
  async function made(session: Session): Promise<Session | undefined> {
    const spec = sessionSpec(session);
    const created = await tryRequest(() => calls.create(sessionCopy(spec, randomUuid)));
    if (created === undefined) await edit(sessionText(spec));
    return created;
  }

  async function createAll(files: readonly PreparedFile[]): Promise<void> {
    asked.value = undefined;
    const ids: string[] = [];
    for (const file of files) {
      if (file.kind === 'broken') continue;
      const session = await made(file.session);
      if (session === undefined) return;
      ids.push(session.id);
    }
    const [only] = ids;
    if (ids.length === 1 && only !== undefined) await router.push(locationOf(only));
    else if (ids.length > 1) toasts.show(`Imported ${ids.length} sessions`);
  }

  async function take(files: readonly File[]): Promise<void> {
    if (files.length === 0 || isReading.value) return;
    isReading.value = true;
    try {
      const library = await knownModules(client);
      const prepared: PreparedFile[] = [];
      for (const file of files) {
        prepared.push(preparedFile(await openSessionFile(file), library, randomUuid));
      }
      const [only] = prepared;
      const isFine = prepared.every((one) => one.kind === 'ready' && one.missing.length === 0);
      if (isAsking?.() !== true) {
        if (isFine) return await createAll(prepared);
        // Errors of a single file are shown beside the lines of its text.
        const text = only?.kind === 'broken' ? only.text : undefined;
        if (prepared.length === 1 && text !== undefined) return await edit(text);
      }
      asked.value = prepared;
    } finally {
      isReading.value = false;
    }
  }

  return {
    isReading,
    asked,
    take,
    edit,
    create: () => createAll(asked.value ?? []),
    cancel: () => (asked.value = undefined),
  };
}
