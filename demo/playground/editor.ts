// The code editor: CodeMirror with the package's own tags, attributes and words completed. Lives in
// a shadow root, where CodeMirror's styles are constructed style sheets, which a strict
// Content-Security-Policy allows. Knows no scene.
import {
  autocompletion,
  completionKeymap,
  snippetCompletion,
  type Completion,
  type CompletionContext,
  type CompletionResult,
} from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { HighlightStyle, LRLanguage, syntaxHighlighting, syntaxTree } from '@codemirror/language';
import { Annotation, EditorState, type Range, StateEffect, StateField } from '@codemirror/state';
import {
  Decoration,
  type DecorationSet,
  EditorView,
  keymap,
  ViewPlugin,
  type ViewUpdate,
} from '@codemirror/view';
import { tags as kinds } from '@lezer/highlight';
import { parser } from '@lezer/html';
import tags from 'virtual:html-data';
import type { Place } from './remarks.js';

export interface Editor {
  /**
   * Replaces what differs from the text, as one step that can be undone. Does not call `changed`.
   */
  setText(text: string): void;
  /** Underlines these places, and no others. */
  mark(places: readonly Place[]): void;
}

/** Marks changes that come from the page, not from the writer. */
const fromPage = Annotation.define<boolean>();

/** @param changed called with the whole text after each change by the writer, undoing included. */
export function startEditor(
  place: HTMLElement,
  text: string,
  changed: (text: string) => void,
): Editor {
  const host = document.createElement('div');
  host.className = 'host';
  const root = host.attachShadow({ mode: 'open' });
  const view = new EditorView({
    root,
    parent: root,
    state: EditorState.create({
      doc: text,
      extensions: [
        history(),
        LRLanguage.define({ name: 'html', parser }),
        syntaxHighlighting(highlighting),
        autocompletion({ override: [complete], icons: false }),
        // Tab keeps moving the focus, so that the keyboard can leave the editor.
        keymap.of([...completionKeymap, ...defaultKeymap, ...historyKeymap]),
        EditorView.lineWrapping,
        unbrokenAttributes,
        faults,
        EditorView.domEventHandlers({ beforeinput: replaceSelected }),
        EditorView.contentAttributes.of({
          'aria-label': 'Markup of the scene',
          tabindex: '0',
          translate: 'no',
        }),
        EditorView.updateListener.of(({ docChanged, state, transactions }) => {
          if (docChanged && !transactions.some((t) => t.annotation(fromPage))) {
            changed(state.doc.toString());
          }
        }),
        theme,
      ],
    }),
  });
  place.replaceChildren(host);
  return {
    setText(next) {
      const now = view.state.doc.toString();
      let start = 0;
      while (start < now.length && now[start] === next[start]) {
        start++;
      }
      let end = 0;
      const most = Math.min(now.length, next.length) - start;
      while (end < most && now[now.length - 1 - end] === next[next.length - 1 - end]) {
        end++;
      }
      view.dispatch({
        changes: {
          from: start,
          to: now.length - end,
          insert: next.slice(start, next.length - end),
        },
        annotations: fromPage.of(true),
      });
    },
    mark(places) {
      view.dispatch({
        effects: setFaults.of(
          Decoration.set(
            places.map(({ from, to }) => fault.range(from, to)),
            true,
          ),
        ),
      });
    },
  };
}

const fault = Decoration.mark({ class: 'cm-fault' });
const setFaults = StateEffect.define<DecorationSet>();

/** The underlined places. They move with the text until they are set again. */
const faults = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update: (marks, { changes, effects }) =>
    effects.find((effect) => effect.is(setFaults))?.value ?? marks.map(changes),
  provide: (field) => EditorView.decorations.from(field),
});

/**
 * Replaces a selection by what is typed. Left to the browser, Chromium keeps the colours of the old
 * text in a style attribute, which the page's policy refuses with a line on the console.
 */
function replaceSelected(event: InputEvent, view: EditorView): boolean {
  const { main, ranges } = view.state.selection;
  if (event.inputType !== 'insertText' || event.isComposing || event.data === null) return false;
  if (main.empty || ranges.length > 1) return false;
  event.preventDefault();
  view.dispatch(view.state.replaceSelection(event.data), {
    userEvent: 'input.type',
    scrollIntoView: true,
  });
  return true;
}

/**
 * Keeps each attribute with its value on one line: lines break between attributes, where there is
 * room for one.
 */
const unbrokenAttributes = ViewPlugin.fromClass(
  class {
    decorations: DecorationSet;

    constructor(view: EditorView) {
      this.decorations = attributesOf(view);
    }

    update({
      view,
      docChanged,
      viewportChanged,
      geometryChanged,
      startState,
      state,
    }: ViewUpdate): void {
      if (
        docChanged ||
        viewportChanged ||
        geometryChanged ||
        syntaxTree(startState) !== syntaxTree(state)
      ) {
        this.decorations = attributesOf(view);
      }
    }
  },
  { decorations: (plugin) => plugin.decorations },
);

const unbroken = Decoration.mark({ class: 'cm-attribute' });

function attributesOf(view: EditorView): DecorationSet {
  const { state, visibleRanges } = view;
  // Longer ones would leave most of a line empty.
  const longest = Math.min(46, view.contentDOM.clientWidth / view.defaultCharacterWidth - 10);
  const marks: Range<Decoration>[] = [];
  for (const { from, to } of visibleRanges) {
    syntaxTree(state).iterate({
      from,
      to,
      enter: (node) => {
        if (node.name === 'Attribute' && node.to - node.from <= longest) {
          marks.push(unbroken.range(node.from, node.to));
        }
      },
    });
  }
  return Decoration.set(marks, true);
}

const highlighting = HighlightStyle.define([
  { tag: kinds.tagName, fontWeight: '600' },
  { tag: kinds.attributeValue, color: 'var(--ambient)' },
  { tag: [kinds.comment, kinds.angleBracket], color: 'var(--quiet)' },
]);

// The page's colours reach into the shadow root as custom properties.
const theme = EditorView.theme({
  '&': {
    height: '100%',
    color: 'var(--ink)',
    backgroundColor: 'var(--paper)',
    fontSize: '0.8125rem',
  },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': { fontFamily: 'var(--mono)', lineHeight: '1.55' },
  '.cm-content': { padding: '0.5rem 0', caretColor: 'var(--ink)' },
  '.cm-line': { padding: '0 0.75rem' },
  '.cm-attribute': { display: 'inline-block', maxWidth: '100%' },
  // The line does not reach into an inline block by itself.
  '.cm-fault, .cm-fault .cm-attribute': {
    textDecoration: 'underline wavy var(--specular) 1px',
    textUnderlineOffset: '3px',
  },
  '.cm-cursor': { borderLeftColor: 'var(--ink)' },
  '.cm-tooltip': {
    backgroundColor: 'var(--paper)',
    color: 'var(--ink)',
    border: '1px solid var(--quiet)',
  },
  '.cm-tooltip-autocomplete ul li[aria-selected]': {
    backgroundColor: 'var(--ink)',
    color: 'var(--paper)',
  },
  '.cm-completionInfo': {
    maxWidth: '20rem',
    font: '0.8125rem/1.4 var(--sans)',
    whiteSpace: 'pre-line',
  },
});

/**
 * Characters before the cursor that are searched for the tag it is in. Longer tags are not
 * completed.
 */
const LOOK_BACK = 2000;

function complete({ state, pos }: CompletionContext): CompletionResult | null {
  const before = state.sliceDoc(Math.max(0, pos - LOOK_BACK), pos);
  const tag = /<([\w-]*)$/.exec(before);
  if (tag) {
    return options(
      pos,
      tag[1]!,
      tags.map((t) => completion(t, 'type')),
    );
  }
  const [, name, rest] = /<(phong-\w+)((?:[^<>"]|"[^"]*")*(?:"[^"]*)?)$/.exec(before) ?? [];
  const element = tags.find((t) => t.name === name);
  if (element === undefined || rest === undefined) return null;
  const value = /([\w-]+)="([\w -]*)$/.exec(rest);
  if (value && !/"[^"]*"[^"]*$/.test(value[0])) {
    const words = element.attributes.find((a) => a.name === value[1])?.values ?? [];
    return options(
      pos,
      /[\w-]*$/.exec(value[2]!)![0],
      words.map((w) => completion(w, 'constant')),
    );
  }
  const attribute = /\s([\w-]*)$/.exec(rest);
  const insideQuotes = rest.split('"').length % 2 === 0;
  if (attribute === null || insideQuotes) return null;
  const written = new Set(Array.from(rest.matchAll(/([\w-]+)=/g), (match) => match[1]));
  const left = element.attributes.filter((a) => !written.has(a.name));
  return options(pos, attribute[1]!, left.map(attributeCompletion));
}

/** Puts the cursor between the quotes. */
function attributeCompletion(attribute: (typeof tags)[number]['attributes'][number]): Completion {
  const plain = completion(attribute, 'property');
  return attribute.valueSet === 'v' ? plain : snippetCompletion(`${attribute.name}="#{}"`, plain);
}

function options(pos: number, typed: string, list: readonly Completion[]): CompletionResult | null {
  return list.length === 0
    ? null
    : { from: pos - typed.length, options: list, validFor: /^[\w-]*$/ };
}

function completion(
  {
    name,
    description,
  }: (typeof tags)[number] | { name: string; description?: string | { value: string } },
  type: string,
): Completion {
  const info = typeof description === 'object' ? description.value : description;
  return { label: name, type, ...(info === undefined ? {} : { info: info.replaceAll('`', '') }) };
}
