import { FlaskConical, Ghost, Share } from '@lucide/vue';
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
    text: 'Make a ghost',
    icon: Ghost,
    refusal: ({ recording }) =>
      recording ? undefined : 'Upload the file to make a ghost of the span',
    dialog: loadLater(() => import('../live/GhostDialog.vue')),
  },
  {
    text: 'Export the span',
    icon: Share,
    dialog: loadLater(() => import('../export/ExportDialog.vue')),
  },
];
