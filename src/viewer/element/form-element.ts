// What <phong-probe> and <phong-exercise> are before their code, an extra, is there: controls of
// forms, whose state it restores.
import { type ExtraCode, reportMissing } from '../model/provided-code.js';
import { Base } from './child-element.js';
import type { FormCode } from './extra-code.js';

export const formElement = (code: ExtraCode<FormCode>) =>
  class extends Base {
    static readonly formAssociated = true;

    connectedCallback(): void {
      code().then(({ follow }) => follow(this), reportMissing);
    }

    formDisabledCallback(): void {
      this.connectedCallback();
    }

    formResetCallback(): void {
      this.formStateRestoreCallback('');
    }

    formStateRestoreCallback(state: string): void {
      code().then(({ restore }) => restore(this, state), reportMissing);
    }
  };
