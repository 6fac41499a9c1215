import {
  moduleEventTopic,
  sessionStatisticsTopic,
  type ModuleStatistics,
  type Session,
} from '@ubii/proto';
import { computed, shallowRef, watch, type ComputedRef, type Ref } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { refusalSentence, useAttempt } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { eventPlace } from '../../sessions/live/event-log.ts';
import { useOwnedSession } from '../../sessions/own/useOwnedSession.ts';
import { isMirrorSessionOf, mirrorSession, type MirrorModule } from './mirror-session.ts';

/** The node that mirrors the pointer. */
export type MirrorPlace =
  | { readonly kind: 'master' }
  | { readonly kind: 'tab' }
  | { readonly kind: 'node'; readonly nodeId: string };

export interface MirrorSession {
  /** The session on the master; `undefined` while there is none. */
  readonly session: ComputedRef<Session | undefined>;
  readonly statistics: ComputedRef<ModuleStatistics | undefined>;
  /** The last error of the module or of a service request, one sentence. */
  readonly trouble: ComputedRef<string | undefined>;
  /** True when the last service request failed, so that the session does not run on the chosen node. */
  readonly hasFailed: ComputedRef<boolean>;
  /** Creates the session again. */
  restart(): Promise<void>;
}

const NODES_INTERVAL_MS = 2000;

/** Keeps a session of this page running at `place`. The client sends the whole session: source, mappings and node. */
export function useMirrorSession(place: Readonly<Ref<MirrorPlace>>): MirrorSession {
  const { client, name, isConnected, nodes } = useConnection();
  nodes.watch(NODES_INTERVAL_MS);
  const loading = useAttempt({ sentenceOf: refusalSentence, catchesAll: true });
  const module = shallowRef<MirrorModule>();
  /** Undefined until the first connection. */
  const clientId = shallowRef<string>();
  watch(isConnected, (connected) => connected && (clientId.value = client.id), { immediate: true });

  async function load(): Promise<void> {
    module.value ??= await loading.attempt(async () => {
      const [{ mirrorPointer }, { moduleToWire }] = await Promise.all([
        import('@ubii/modules'),
        import('@ubii/pm-sandbox'),
      ]);
      return moduleToWire(mirrorPointer);
    });
  }
  void load();

  /** Without another node, the module stays where it is. */
  const chosen = shallowRef('master');
  watch(
    place,
    (next) => {
      const wanted = next.kind === 'node' ? next.nodeId : next.kind;
      if (wanted !== '') chosen.value = wanted;
    },
    { immediate: true },
  );
  const owned = useOwnedSession({
    life: 'page',
    spec: () =>
      module.value && clientId.value !== undefined
        ? {
            place: chosen.value,
            session: mirrorSession({
              clientId: clientId.value,
              clientName: name.value,
              module: module.value,
            }),
          }
        : undefined,
    // It would mirror the pointer a second time.
    isLeftover: (session) => isMirrorSessionOf(session, client.id),
  });

  const id = computed(() => owned.session.value?.id);
  const { newest: report } = useTopic(() => id.value && sessionStatisticsTopic(id.value), {
    format: 'sessionStatistics',
  });
  /** The last error of the module, until the next change. */
  const event = shallowRef<string>();
  useTopic(() => id.value && moduleEventTopic(id.value), {
    format: 'moduleEvent',
    keep: 0,
    onRecord({ value }) {
      const at = eventPlace(value);
      event.value = at === '' ? value.message : `${value.message} (${at})`;
    },
  });
  watch(chosen, () => (event.value = undefined));

  const failure = computed(() => loading.problem.value ?? owned.failure.value);
  return {
    session: owned.session,
    statistics: computed(() => report.value?.value.modules[0]),
    trouble: computed(() => event.value ?? failure.value ?? owned.trouble.value),
    hasFailed: computed(() => failure.value !== undefined),
    async restart() {
      event.value = undefined;
      await load();
      await owned.restart();
    },
  };
}
