import type { GraphEditor } from '../editing/graph-editor.ts';
import type { CanvasStage } from './canvas-stage.ts';

const ZOOM_STEP = 1.25;
/** Distance panned by PageUp and PageDown, as a share of the visible size. */
const PAGE = 0.8;

/** Pans and zooms: F, Home and 1 show all, 2 the selection, 0 zooms to 100 %. */
export function viewKey(
  stage: CanvasStage,
  editor: GraphEditor,
  { fit }: { fit(): void },
  { key, shiftKey }: KeyboardEvent,
): boolean {
  switch (key) {
    case 'f':
    case 'F':
    case 'Home':
    case '1':
      fit();
      return true;
    case '2': {
      const { nodes } = editor.selection.value;
      if (nodes.size === 0) return false;
      void stage.fit(nodes);
      return true;
    }
    case '0':
      void stage.zoomTo(1);
      return true;
    case '+':
    case '=':
      void stage.zoomTo(stage.view.value.k * ZOOM_STEP);
      return true;
    case '-':
      void stage.zoomTo(stage.view.value.k / ZOOM_STEP);
      return true;
    case 'PageUp':
    case 'PageDown': {
      const { width, height } = stage.viewport.value;
      const way = key === 'PageUp' ? PAGE : -PAGE;
      void stage.pan(shiftKey ? { x: width * way, y: 0 } : { x: 0, y: height * way });
      return true;
    }
    default:
      return false;
  }
}
