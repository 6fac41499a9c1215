import { Copy, Gauge, ListTree, Pencil, Unplug, Zap } from '@lucide/vue';
import type { MenuItem } from '../../ui/UiMenu.vue';
import type { ClientView } from '../model/client-view.ts';

/** Action of a client menu. */
export type ClientIntent =
  | 'identify'
  | 'rename'
  | 'topics'
  | 'copy-id'
  | 'throttle'
  | 'unthrottle'
  | 'disconnect';

/** Menu of a client. Irreversible actions are last. */
export function clientMenu(
  view: ClientView,
  run: (intent: ClientIntent, view: ClientView) => void,
): readonly MenuItem[] {
  const does = (intent: ClientIntent) => () => run(intent, view);
  const isThrottled = view.activity?.throttle !== undefined;
  return [
    { text: 'Identify', icon: Zap, disabled: view.isSelf, run: does('identify') },
    { text: 'Rename', icon: Pencil, shortcut: 'F2', run: does('rename') },
    { text: 'Show topics', icon: ListTree, run: does('topics') },
    { text: 'Copy client id', icon: Copy, run: does('copy-id') },
    { kind: 'separator' },
    { text: isThrottled ? 'Change throttle' : 'Throttle', icon: Gauge, run: does('throttle') },
    ...(isThrottled ? [{ text: 'Remove throttle', icon: Gauge, run: does('unthrottle') }] : []),
    {
      text: 'Disconnect',
      icon: Unplug,
      shortcut: 'Del',
      danger: true,
      run: does('disconnect'),
    },
  ];
}
