import type { ControlSpec, TopicViewer } from '../topic-viewer.ts';
import ButtonControl from './ButtonControl.vue';
import ButtonOptions from './ButtonOptions.vue';
import { BUTTON_FORMATS, PAD_FORMATS, SLIDER_FORMATS, TEXT_FORMATS } from './control-values.ts';
import PadControl from './PadControl.vue';
import PadOptions from './PadOptions.vue';
import SliderControl from './SliderControl.vue';
import SliderOptions from './SliderOptions.vue';
import TextControl from './TextControl.vue';

/** A view that publishes on its topic. */
export type ControlViewer = TopicViewer & { readonly control: ControlSpec };

/** The head of a topic publishes by itself, so its page has no controls. */
function aControl(
  viewer: Pick<ControlViewer, 'id' | 'title' | 'component' | 'control'>,
): ControlViewer {
  return {
    ...viewer,
    fits: (format) => viewer.control.formats.includes(format),
    isSecond: () => true,
    isInDetail: false,
  };
}

/** Views that publish, in panels. */
export const CONTROLS: readonly ControlViewer[] = [
  aControl({
    id: 'slider',
    title: 'Slider',
    component: SliderControl,
    control: {
      formats: SLIDER_FORMATS,
      options: { title: 'Range and step', component: SliderOptions },
      isLow: true,
    },
  }),
  aControl({
    id: 'button',
    title: 'Button',
    component: ButtonControl,
    control: {
      formats: BUTTON_FORMATS,
      options: { title: 'Mode and values', component: ButtonOptions },
      isLow: true,
    },
  }),
  aControl({
    id: 'pad',
    title: 'Pad',
    component: PadControl,
    control: {
      formats: PAD_FORMATS,
      options: { title: 'Coordinates of the pad', component: PadOptions },
      isLow: false,
    },
  }),
  aControl({
    id: 'text',
    title: 'Text',
    component: TextControl,
    control: { formats: TEXT_FORMATS, isLow: true },
  }),
];
