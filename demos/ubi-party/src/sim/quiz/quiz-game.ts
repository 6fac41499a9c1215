import { placeOf, placesByScore, STEPS_PER_SECOND, STEP_S, withPace } from '../game.ts';
import type { Controls, Feedback, Game, Hud, Seat, WithPace } from '../game.ts';
import { clamp } from '../plane/plane.ts';
import { drawInteger, randomState, type WithRandom } from '../random.ts';
import { standInRows } from '../stand-in-rows.ts';
import { STATEMENTS } from './statements.ts';

interface Answerer {
  readonly seat: Seat;
  /** Units to the right of the middle: left says false, right says true. */
  x: number;
  /** The step at which the piece came to the side where it is. */
  since: number;
  score: number;
  /** The points of the newest question; 0: wrong. */
  won: number;
}

export interface QuizState extends WithRandom, WithPace {
  /** Steps since the start. */
  step: number;
  /** Indices of `STATEMENTS`, in their order. */
  readonly asked: readonly number[];
  readonly answerers: Answerer[];
}

const QUESTIONS = 7;
const ANSWER = 9 * STEPS_PER_SECOND;
const QUESTION = ANSWER + 3 * STEPS_PER_SECOND;
const RIGHT = 100;
/** On top, for who stood on the right side from the first moment. */
const QUICK = 40;
/** Units. A piece nearer to the middle says nothing. */
const EDGE = 8;
const UNDECIDED = 2;
/** Units per second. */
const SPEED = 12;

/** Tilt Quiz: true or false, seven times. Quicker answers count a little more. */
export const quizGame: Game<QuizState, { readonly speed: number }> = {
  id: 'quiz',
  title: 'Tilt Quiz',
  explanation: [
    'The screen shows a statement. Steer your piece to the left: false. To the right: true.',
    'You can change your mind until the time is up.',
    'A right answer gives 100 points, a quick one up to 40 more.',
  ],
  controller: { steering: 'wheel', button: 'Middle', isHeld: false },
  settings: { speed: 1 },
  start(setup) {
    const random = { random: randomState(setup.seed) };
    const left = STATEMENTS.map((_, index) => index);
    const draw = (): number => left.splice(drawInteger(random, 0, left.length - 1), 1)[0]!;
    const asked = Array.from({ length: QUESTIONS }, draw);
    const answerers = setup.seats.map((seat) => ({ seat, x: 0, since: 0, score: 0, won: 0 }));
    return { ...random, ...withPace(setup), step: 0, asked, answerers };
  },
  step(state, controls, { speed }) {
    state.step += 1;
    const { answer, question } = stepsOf(state);
    const at = state.step % question;
    for (const one of state.answerers) {
      if (at === 0) Object.assign(one, { x: 0, since: state.step, won: 0 });
      else if (at < answer) slide(one, controls(one.seat), state.step, speed);
      else if (at === answer) judge(one, state);
    }
  },
  isOver: (state) => state.step >= QUESTIONS * stepsOf(state).question - 1,
  places: ({ answerers }) =>
    placesByScore(
      answerers.map(({ seat }) => seat),
      (seat) => answerers.find((one) => one.seat === seat)!.score,
    ),
  feedback,
  hud,
  bot(state, seat) {
    const { isTrue, number } = questionOf(state);
    const isSure = (seat * 5 + number * 3 + state.asked[0]!) % 10 < 7;
    const isThinking = state.step % stepsOf(state).question < (1 + (seat % 4)) * STEPS_PER_SECOND;
    return { x: isThinking ? 0 : isSure === isTrue ? 1 : -1, y: 0, isPressed: false };
  },
  pieces: ({ answerers }) =>
    answerers.map(({ seat, x }, index) => ({ seat, ...standInRows(x, index, answerers.length) })),
};

/** Steps to answer, and of a whole question with its result. */
const stepsOf = ({ pace = 1 }: WithPace) => ({ answer: ANSWER * pace, question: QUESTION * pace });

/** The pad brings a piece back to the middle. */
function slide(one: Answerer, controls: Controls, step: number, speed: number): void {
  const before = sideOf(one);
  const way = controls.isPressed ? clamp(-one.x, -1, 1) : clamp(controls.x, -1, 1);
  one.x = clamp(one.x + way * SPEED * speed * STEP_S, -EDGE, EDGE);
  if (sideOf(one) !== before) one.since = step;
}

function judge(one: Answerer, state: QuizState): void {
  if (sideOf(one) !== (questionOf(state).isTrue ? 1 : -1)) return;
  one.won = RIGHT + Math.round((QUICK * (state.step - one.since)) / stepsOf(state).answer);
  one.score += one.won;
}

/** 1: says true, -1: says false, 0: says nothing. */
const sideOf = ({ x }: Answerer): number => (Math.abs(x) < UNDECIDED ? 0 : Math.sign(x));

function questionOf(state: QuizState) {
  const { answer, question } = stepsOf(state);
  const number = Math.min(QUESTIONS - 1, Math.floor(state.step / question));
  const [text, isTrue] = STATEMENTS[state.asked[number]!]!;
  const leftSteps = answer - (state.step % question);
  return { text, isTrue, number, leftSteps, isShown: leftSteps <= 0 };
}

const secondsOf = (steps: number): number => Math.ceil(steps / STEPS_PER_SECOND);

const ANSWERS: Readonly<Record<number, string>> = { 1: 'True', [-1]: 'False', 0: 'Tilt to answer' };

function feedback(state: QuizState, seat: Seat): Feedback {
  const own = state.answerers.find((one) => one.seat === seat);
  const { text, isTrue, number, leftSteps, isShown } = questionOf(state);
  const isWrong = isShown && own?.won === 0;
  const result = isWrong ? `It is ${isTrue ? 'true' : 'false'}.` : `${own?.won ?? 0} points!`;
  return {
    place: placeOf(quizGame.places(state), seat),
    of: state.answerers.length,
    headline: isShown ? (isWrong ? 'Wrong' : 'Right') : ANSWERS[own ? sideOf(own) : 0]!,
    sentence: isShown ? result : text,
    progress: number / QUESTIONS,
    gauge: Math.max(0, leftSteps) / stepsOf(state).answer,
    ...(!isShown && { secondsLeft: secondsOf(leftSteps) }),
    isReady: !isShown && own !== undefined && sideOf(own) !== 0,
    isOut: false,
    hitAt: isWrong ? state.step + leftSteps : 0,
  };
}

function hud(state: QuizState): Hud {
  const { text, isTrue, number, leftSteps, isShown } = questionOf(state);
  const notes = state.answerers.map(({ seat, score, won }) => [
    seat,
    isShown && won > 0 ? `${score} (+${won})` : String(score),
  ]);
  return {
    headline: isShown ? (isTrue ? 'It’s true' : 'It’s false') : `${number + 1} of ${QUESTIONS}`,
    question: { text, left: 'False', right: 'True' },
    notes: Object.fromEntries(notes) as Record<Seat, string>,
    out: [],
    ...(!isShown && { corner: { value: String(secondsOf(leftSteps)), label: 'seconds left' } }),
  };
}
