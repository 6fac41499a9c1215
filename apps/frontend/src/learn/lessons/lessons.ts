import type { Lesson } from '../model/lesson.ts';
import { callAService } from './call-a-service.ts';
import { firstModule } from './first-module.ts';
import { manyPhones } from './many-phones.ts';
import { ownProgram } from './own-program.ts';
import { seeAPhone } from './see-a-phone.ts';
import { wireTwoTopics } from './wire-two-topics.ts';

/** In the order in which they build on each other. */
export const LESSONS: readonly Lesson[] = [
  seeAPhone,
  wireTwoTopics,
  firstModule,
  manyPhones,
  callAService,
  ownProgram,
];
