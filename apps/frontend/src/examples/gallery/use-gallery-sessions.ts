import { ConnectionError } from '@ubii/client-web';
import { ServiceError, SessionState, type Session } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
import { useRouter } from 'vue-router';
import { useConnection } from '../../connection/useConnection.ts';
import { graphLocation } from '../../graph/routes.ts';
import { useSessionActions } from '../../sessions/actions/useSessionActions.ts';
import { isAlive, sessionState } from '../../sessions/state/session-state.ts';
import type { GalleryEntry } from './gallery.ts';
import { gallerySession, inputClient, sessionOfEntry, withInputsOf } from './gallery-session.ts';
import { usePageInputs } from './inputs/page-inputs.ts';
import type { PreviewKit } from './preview/preview-kit.ts';

/** The sessions of the gallery on the master, and what can be done with them. */
export interface GallerySessions {
  /** The session of an example, when there is one. */
  of(entry: GalleryEntry): Session | undefined;
  isRunning(entry: GalleryEntry): boolean;
  /** Ids of examples for which a call is under way. */
  readonly busy: Readonly<ShallowRef<ReadonlySet<string>>>;
  /** Why the last call failed, by the id of the example. */
  readonly failures: Readonly<ShallowRef<ReadonlyMap<string, string>>>;
  /** Creates the session unless there is one, starts it, and opens its graph. */
  start(entry: GalleryEntry): Promise<void>;
  /** Creates the session unless there is one, and opens its graph. */
  open(entry: GalleryEntry): Promise<void>;
  stop(entry: GalleryEntry): Promise<void>;
  remove(entry: GalleryEntry): Promise<void>;
}

/** There is one session of each example for all: starting it again opens the one there is. */
export function useGallerySessions(loadKit: () => Promise<PreviewKit>): GallerySessions {
  const { client, clients, sessions } = useConnection();
  const router = useRouter();
  const actions = useSessionActions();
  const pageInputs = usePageInputs();
  const busy = shallowRef<ReadonlySet<string>>(new Set());
  const failures = shallowRef<ReadonlyMap<string, string>>(new Map());

  const of = (entry: GalleryEntry): Session | undefined =>
    sessionOfEntry(entry, sessions.list.value ?? []);

  async function attempt(entry: GalleryEntry, intent: () => Promise<void>): Promise<void> {
    if (busy.value.has(entry.id)) return;
    busy.value = new Set([...busy.value, entry.id]);
    failures.value = new Map([...failures.value].filter(([id]) => id !== entry.id));
    try {
      await intent();
    } catch (cause) {
      if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
      failures.value = new Map([...failures.value, [entry.id, cause.message]]);
    } finally {
      busy.value = new Set([...busy.value].filter((id) => id !== entry.id));
    }
  }

  /** The session there is, or a new one. Its inputs are this page's, unless another page gives them. */
  async function ready(entry: GalleryEntry): Promise<Session> {
    const there = of(entry);
    if (there === undefined) {
      const spec = (await loadKit()).spec(entry);
      return actions.calls.create(gallerySession(entry, spec, client.id));
    }
    const giver = inputClient(entry, there);
    const isOurs = giver === undefined || giver === client.id;
    if (isOurs || (isAlive(there) && clients.find(giver) !== undefined)) return there;
    return actions.calls.update(there, { ioMappings: withInputsOf(entry, there, client.id) });
  }

  return {
    of,
    isRunning: (entry) => {
      const session = of(entry);
      return (
        session !== undefined &&
        (isAlive(session) || sessionState(session) === SessionState.SESSION_STARTING)
      );
    },
    busy,
    failures,
    start: (entry) =>
      attempt(entry, async () => {
        const session = await ready(entry);
        const giver = inputClient(entry, session);
        if (giver === undefined || giver === client.id) {
          pageInputs.give(
            session.id,
            entry.inputs.map(({ input }) => input),
          );
        }
        if (!isAlive(session)) await actions.calls.act(session, 'start');
        await router.push(graphLocation(session.id));
      }),
    open: (entry) =>
      attempt(entry, async () => void (await router.push(graphLocation((await ready(entry)).id)))),
    stop: (entry) =>
      attempt(entry, async () => {
        const session = of(entry);
        if (session) await actions.calls.act(session, 'stop');
      }),
    remove: async (entry) => {
      const session = of(entry);
      if (session) await actions.remove(session);
    },
  };
}
