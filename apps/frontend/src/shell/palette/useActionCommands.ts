import {
  Bug,
  CircleDot,
  ConciergeBell,
  Copy,
  Cpu,
  FlagTriangleRight,
  Keyboard,
  Monitor,
  Moon,
  Pencil,
  Plus,
  QrCode,
  RotateCw,
  Send,
  SquareTerminal,
  Sun,
} from '@lucide/vue';
import { useClipboard } from '@vueuse/core';
import { computed, type ComputedRef } from 'vue';
import { useRouter } from 'vue-router';
import { bestAddress } from '../../joining/connect-phone/addresses.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { CONNECT_PROGRAM_PATH } from '../../locations/connect-location.ts';
import type { Command } from '../../page/command.ts';
import { useShell } from '../../page/shell.ts';
import { useDiagnostics } from '../../settings/diagnostics/useDiagnostics.ts';
import { useTabNode } from '../../tab-node/useTabNode.ts';
import { useThemeChoice } from '../../theme/useTheme.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { useRecordingActions } from '../useRecordingActions.ts';
import { shortcutsOn } from '../shortcuts.ts';

/** The actions that are available on every page. */
export function useActionCommands(): ComputedRef<Command[]> {
  const router = useRouter();
  const shell = useShell();
  const theme = useThemeChoice();
  const toasts = useToasts();
  const tab = useTabNode();
  const { master, isConnected, connect } = useConnection();
  const { copy } = useClipboard({ legacy: true });
  const recordings = useRecordingActions();
  const saveDiagnostics = useDiagnostics();
  const hasPhoneKey = shortcutsOn(router.currentRoute.value.meta).some(({ keys }) => keys === 'C');
  const go = (to: string) => () => void router.push(to);

  async function copyAddress(): Promise<void> {
    const address = bestAddress(master.view.value?.latest.addresses ?? []) ?? location.origin;
    await copy(address);
    toasts.show(`Copied ${address}`);
  }

  const action = (id: string, title: string, rest: Pick<Command, 'icon' | 'shortcut' | 'run'>) => ({
    id: `action ${id}`,
    kind: 'action' as const,
    title,
    ...rest,
  });

  const always: Command[] = [
    action('connect-phone', 'Connect a phone', {
      icon: QrCode,
      ...(hasPhoneKey ? { shortcut: 'C' } : {}),
      run: () => shell.open('connect-phone'),
    }),
    action('connect-program', 'Connect a program', {
      icon: SquareTerminal,
      run: go(CONNECT_PROGRAM_PATH),
    }),
    action('keep-flight', 'Keep the last minutes of the flight recorder', {
      icon: CircleDot,
      shortcut: 'K',
      run: recordings.keep,
    }),
    action('mark', 'Mark this moment in what is recorded', {
      icon: FlagTriangleRight,
      run: recordings.mark,
    }),
    action('new-session', 'New session', { icon: Plus, run: go('/sessions/new') }),
    action('publish', 'Publish a record', { icon: Send, run: go('/publish') }),
    action('call-service', 'Call a service', { icon: ConciergeBell, run: go('/calls') }),
    action('copy-address', 'Copy the master’s address', {
      icon: Copy,
      run: () => void copyAddress(),
    }),
    action('rename', 'Rename this browser', { icon: Pencil, run: () => shell.open('identity') }),
    ...(
      [
        ['dark', 'Dark theme', Moon],
        ['light', 'Light theme', Sun],
        ['system', 'System theme', Monitor],
      ] as const
    ).map(([choice, title, icon]) =>
      action(`theme-${choice}`, title, { icon, run: () => (theme.value = choice) }),
    ),
    action('shortcuts', 'Keyboard shortcuts', {
      icon: Keyboard,
      shortcut: '?',
      run: () => shell.open('shortcuts'),
    }),
    action('diagnostics', 'Save diagnostics for a bug report', {
      icon: Bug,
      run: () => void saveDiagnostics(),
    }),
  ];
  const reconnect = action('reconnect', 'Reconnect to the master', {
    icon: RotateCw,
    run: connect,
  });

  return computed(() => {
    const isOn = tab.isChosen.value;
    const runsModules = action(
      'tab-node',
      isOn ? 'Stop running modules in this tab' : 'Run modules in this tab',
      { icon: Cpu, run: () => (tab.isChosen.value = !isOn) },
    );
    return [...(isConnected.value ? [] : [reconnect]), ...always, runsModules];
  });
}
