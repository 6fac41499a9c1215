import {
  Blocks,
  Copy,
  Cpu,
  Keyboard,
  Monitor,
  Moon,
  Pencil,
  Play,
  Plus,
  QrCode,
  RotateCw,
  Phone,
  Send,
  Square,
  Sun,
  Workflow,
} from '@lucide/vue';
import { useClipboard } from '@vueuse/core';
import { computed, type ComputedRef } from 'vue';
import { useRouter } from 'vue-router';
import { clientPath } from '../../clients/routes.ts';
import { bestAddress } from '../../connect-phone/addresses.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { EXAMPLES } from '../../examples/catalogue.ts';
import { moduleLocation } from '../../modules/routes.ts';
import { playerIdentity } from '../../players/player-identity.ts';
import { sessionLocation } from '../../sessions/routes.ts';
import { sessionState, stateLook } from '../../sessions/state/session-state.ts';
import { useTabNode } from '../../tab-node/useTabNode.ts';
import { useThemeChoice } from '../../theme/useTheme.ts';
import { isInternalTopic } from '../../topics/internal-topics.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { PAGES, SETTINGS_PAGE } from '../pages.ts';
import { useShell } from '../shell.ts';
import type { Command } from './command.ts';

/** While the palette is open, topics that come and go are followed this often, milliseconds. */
const TOPICS_INTERVAL_MS = 1000;

/** Everything the palette finds, kept up to date while it is open. */
export function useCommands(): ComputedRef<Command[]> {
  const router = useRouter();
  const shell = useShell();
  const theme = useThemeChoice();
  const toasts = useToasts();
  const { client, clients, topics, sessions, master, isConnected, connect } = useConnection();
  const tab = useTabNode();
  const { copy } = useClipboard({ legacy: true });
  topics.watch(TOPICS_INTERVAL_MS);

  const go = (to: string) => () => void router.push(to);

  const pages = [...PAGES, SETTINGS_PAGE].map(({ title, to, icon, shortcut }): Command => ({
    id: `page ${to}`,
    kind: 'page',
    title,
    icon,
    shortcut,
    run: go(to),
  }));

  const examples = EXAMPLES.map(({ id, title, sentence, path }): Command => ({
    id: `example ${id}`,
    kind: 'example',
    title,
    detail: sentence,
    icon: Play,
    run: go(path),
  }));

  async function copyAddress(): Promise<void> {
    const address = bestAddress(master.view.value?.latest.addresses ?? []) ?? location.origin;
    await copy(address);
    toasts.show(`Copied ${address}`);
  }

  const actions: Command[] = [
    {
      id: 'action connect-phone',
      kind: 'action',
      title: 'Connect a phone',
      icon: QrCode,
      shortcut: 'C',
      run: () => shell.open('connect-phone'),
    },
    {
      id: 'action new-session',
      kind: 'action',
      title: 'New session',
      icon: Plus,
      run: go('/sessions/new'),
    },
    {
      id: 'action publish',
      kind: 'action',
      title: 'Publish a record',
      icon: Send,
      run: go('/publish'),
    },
    {
      id: 'action call-service',
      kind: 'action',
      title: 'Call a service',
      icon: Phone,
      run: go('/calls'),
    },
    {
      id: 'action copy-address',
      kind: 'action',
      title: 'Copy the master’s address',
      icon: Copy,
      run: () => void copyAddress(),
    },
    {
      id: 'action rename',
      kind: 'action',
      title: 'Rename this browser',
      icon: Pencil,
      run: () => shell.open('identity'),
    },
    ...(
      [
        ['dark', 'Dark theme', Moon],
        ['light', 'Light theme', Sun],
        ['system', 'Theme of the system', Monitor],
      ] as const
    ).map(([choice, title, icon]): Command => ({
      id: `action theme-${choice}`,
      kind: 'action',
      title,
      icon,
      run: () => (theme.value = choice),
    })),
    {
      id: 'action shortcuts',
      kind: 'action',
      title: 'Keyboard shortcuts',
      icon: Keyboard,
      shortcut: '?',
      run: () => shell.open('shortcuts'),
    },
  ];

  const reconnect: Command = {
    id: 'action reconnect',
    kind: 'action',
    title: 'Connect to the master now',
    icon: RotateCw,
    run: connect,
  };

  const runsModules = computed((): Command => {
    const isOn = tab.isChosen.value;
    return {
      id: 'action tab-node',
      kind: 'action',
      title: isOn ? 'Run no more modules in this tab' : 'Run modules in this tab',
      icon: Cpu,
      run: () => (tab.isChosen.value = !isOn),
    };
  });

  /** A failed intent shows where the session is shown. */
  async function act(id: string, action: 'start' | 'stop'): Promise<void> {
    const service = action === 'start' ? 'sessionRuntimeStart' : 'sessionRuntimeStop';
    await client.call(service, { id }).catch(() => router.push(sessionLocation(id)));
  }
  const runs = computed(() =>
    (sessions.list.value ?? []).flatMap((session): Command[] => {
      const { id, name } = session;
      const { word, actions: can } = stateLook(sessionState(session));
      const title = name || 'Session without a name';
      const open: Command = {
        id: `session ${id}`,
        kind: 'session',
        title,
        detail: word,
        icon: Workflow,
        run: () => void router.push(sessionLocation(id)),
      };
      const action = (['start', 'stop'] as const).find((one) => can.includes(one));
      if (action === undefined) return [open];
      const verb = action === 'start' ? 'Start' : 'Stop';
      const icon = action === 'start' ? Play : Square;
      const intent: Command = {
        id: `session ${action} ${id}`,
        kind: 'session',
        title: `${verb} ${title}`,
        icon,
        run: () => void act(id, action),
      };
      return [open, intent];
    }),
  );

  /** Modules that sessions use; the page finds the others. */
  const modules = computed(() => {
    const names = (sessions.list.value ?? []).flatMap(({ processingModules }) =>
      processingModules.map(({ name }) => name),
    );
    return [...new Set(names)].map((name): Command => ({
      id: `module ${name}`,
      kind: 'module',
      title: name,
      icon: Blocks,
      run: () => void router.push(moduleLocation(name)),
    }));
  });

  const people = computed(() =>
    (clients.list.value ?? []).map(({ id, name, description }): Command => ({
      id: `client ${id}`,
      kind: 'client',
      title: name || id,
      detail: description,
      letter: playerIdentity(id, name).letter,
      run: go(clientPath(id)),
    })),
  );

  const streams = computed(() =>
    [...(topics.rates.value?.values() ?? [])]
      .filter(({ statistic }) => !isInternalTopic(statistic.topic))
      .map(({ statistic }): Command => ({
        id: `topic ${statistic.topic}`,
        kind: 'topic',
        title: statistic.topic,
        format: statistic.dataFormat,
        run: go(`/topics?topic=${encodeURIComponent(statistic.topic)}`),
      })),
  );

  return computed(() => [
    ...shell.pageCommands.value,
    ...pages,
    ...examples,
    ...(isConnected.value ? [] : [reconnect]),
    ...actions,
    runsModules.value,
    ...runs.value,
    ...modules.value,
    ...people.value,
    ...streams.value,
  ]);
}
