import { createPageClock } from '@ubii/client-web/processing';

/** Time of pictures: their session goes on at its rate while another page, such as its graph, is in front. */
export const pictureClock = createPageClock();
