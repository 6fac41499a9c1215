import { FlaskConical, Share } from '@lucide/vue';
import { loadLater } from '../../ui/load-later.ts';
import type { SpanAction } from '../opened/span-action.ts';

/** All actions of the menu of a span, in its order: one line for each feature. */
export const SPAN_ACTIONS: readonly SpanAction[] = [
  {
    text: 'Make a test case of a module',
    icon: FlaskConical,
    dialog: loadLater(() => import('../cases/CaseDialog.vue')),
  },
  {
    text: 'Export the span',
    icon: Share,
    dialog: loadLater(() => import('../export/ExportDialog.vue')),
  },
];
